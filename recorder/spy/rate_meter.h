#pragma once

#include <array>
#include <cstdint>

#include "core/base/time.h"

namespace rocinante {

/// Events per second over about the last two seconds. Times must not go back.
class RateMeter {
 public:
  void hit(LogTime time) {
    advance(time);
    if (first_ == LogTime{}) first_ = time;
    ++counts_[static_cast<std::size_t>(slot_) % kSlots];
  }

  /// Over the whole span, or since the first event if that is shorter.
  double perSecond(LogTime now) {
    if (first_ == LogTime{}) return 0;
    advance(now);
    std::uint64_t sum = 0;
    for (const std::uint32_t count : counts_) sum += count;
    // The current slot is not complete yet.
    const Nanoseconds span = now.time_since_epoch() - (slot_ - kSlots + 1) * kSlot;
    const Nanoseconds since_first = now - first_;
    const Nanoseconds over = since_first < span ? since_first : span;
    // Less than half a second is too short to measure a rate.
    if (over < std::chrono::milliseconds(500)) return 0;
    return static_cast<double>(sum) / std::chrono::duration<double>(over).count();
  }

 private:
  static constexpr std::int64_t kSlots = 8;
  static constexpr Nanoseconds kSlot = std::chrono::milliseconds(250);

  void advance(LogTime time) {
    const std::int64_t slot = time.time_since_epoch() / kSlot;
    if (slot <= slot_) return;
    const std::int64_t passed = slot - slot_ < kSlots ? slot - slot_ : kSlots;
    for (std::int64_t i = 1; i <= passed; ++i) {
      counts_[static_cast<std::size_t>(slot - passed + i) % kSlots] = 0;
    }
    slot_ = slot;
  }

  std::array<std::uint32_t, kSlots> counts_{};
  std::int64_t slot_ = 0;
  LogTime first_{};
};

}  // namespace rocinante
