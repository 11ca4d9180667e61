#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// Counts the rows of a text some value of which a later row of the same time states anew: of equal
/// times the last one wins. Bounded: what is stated of names beyond the first 65,536 is not
/// followed.
class OverwrittenRows {
 public:
  static constexpr std::size_t kNoName = ~std::size_t{0};

  /// The number of a name of values, the same for the same name; kNoName beyond the limit.
  std::size_t numberOf(std::string_view name);
  /// A row states a value of this name.
  void state(std::size_t name, Nanoseconds time, std::size_t line);

  std::uint64_t count() const { return count_; }
  /// Of the first that was overwritten.
  std::size_t firstLine() const { return first_line_; }

 private:
  struct Stated {
    Nanoseconds time{};
    std::size_t line = 0;  ///< 0: nothing was stated
  };
  std::map<std::string, std::size_t, std::less<>> numbers_;
  std::vector<Stated> last_;       ///< by name
  std::set<std::size_t> counted_;  ///< lines, the latest of them
  std::uint64_t count_ = 0;
  std::size_t first_line_ = 0;
};

}  // namespace rocinante
