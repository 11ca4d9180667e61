#pragma once

#include <cstdint>

namespace rocinante {

/// Extends the kernel's 32-bit count of drops beyond its wrap. Readings may come out of order:
/// a datagram carries the count at the time it was queued, SO_MEMINFO the current one.
class DropCounter {
 public:
  /// Readings less than 2^31 ahead of the highest advance the count; others are older.
  void update(std::uint32_t reading);
  std::uint64_t total() const { return total_; }

 private:
  std::uint64_t total_ = 0;
};

}  // namespace rocinante
