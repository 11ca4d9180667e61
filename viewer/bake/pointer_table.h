#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// Values whose bytes in memory are those of the file, in lists.
template <class Value>
inline constexpr bool kIsRaw =
    std::is_same_v<Value, Vertex> || std::is_same_v<Value, std::uint32_t> ||
    std::is_same_v<Value, std::byte>;

/// Numbers shared values in the order in which they come.
template <class Value>
class PointerTable {
 public:
  /// The number of a null pointer.
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::uint32_t number(const std::shared_ptr<const Value>& shared) {
    if (!shared) return kNone;
    const auto [known, is_new] =
        numbers_.try_emplace(shared.get(), static_cast<std::uint32_t>(values_.size()));
    if (is_new) values_.push_back(shared.get());
    return known->second;
  }
  /// Borrowed from the cell; may grow while one of them is written.
  const std::vector<const Value*>& values() const { return values_; }

 private:
  std::map<const Value*, std::uint32_t> numbers_;  // lookup only, never iterated
  std::vector<const Value*> values_;
};

}  // namespace rocinante
