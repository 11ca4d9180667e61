#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/copy/copy_source.h"

namespace rocinante {

/// Merges several sources, ordered by time, argument order, and their own order.
class CopyMerge {
 public:
  /// The sources must outlive the merge and must not move.
  explicit CopyMerge(std::vector<CopySource>& sources);

  /// The next item, or null at the end; valid until the next call. Items that several pieces of one
  /// session hold are given once.
  Result<const CopyItem*> next();
  std::uint64_t repeated() const { return repeated_; }

 private:
  /// Equal items of one time from one source.
  struct Seen {
    std::size_t source = 0;
    std::uint64_t captured = 0;
    std::uint64_t all = 0;
  };

  Status refill();
  std::optional<std::size_t> earliest() const;
  bool isRepeated(std::size_t source, const CopyItem& item);
  bool sameSession(std::size_t a, std::size_t b) const;
  bool othersAt(std::size_t source, LogTime time) const;

  std::vector<CopySource>& sources_;
  std::vector<const CopyItem*> heads_;
  bool filled_ = false;               ///< heads_ was filled from every source
  std::optional<std::size_t> taken_;  ///< source of the item returned last
  /// Items at seen_time_, which another source may repeat, by identityOf().
  std::map<std::array<std::byte, 16>, std::vector<Seen>> seen_;
  LogTime seen_time_{};
  std::uint64_t repeated_ = 0;
};

}  // namespace rocinante
