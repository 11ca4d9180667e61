#pragma once

#include <cstddef>

#include "core/base/time.h"

namespace rocinante {

/// Restatements and greetings are sent with at most 64 datagrams in 10 ms (docs/subscriptions.md).
class RestatingPace {
 public:
  static constexpr std::size_t kDatagrams = 64;
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(10);
  /// What takes longer has no part=.
  static constexpr Nanoseconds kLongest = std::chrono::milliseconds(500);
  static constexpr std::size_t kMaxWithParts =
      kDatagrams * static_cast<std::size_t>(kLongest / kPeriod);

  bool allows(LogTime now) {
    if (now - began_ >= kPeriod) {
      began_ = now;
      sent_ = 0;
    }
    return sent_ < kDatagrams;
  }
  void sent(std::size_t datagrams) { sent_ += datagrams; }
  LogTime allowsAt() const { return sent_ < kDatagrams ? began_ : began_ + kPeriod; }

 private:
  LogTime began_{};
  std::size_t sent_ = 0;
};

}  // namespace rocinante
