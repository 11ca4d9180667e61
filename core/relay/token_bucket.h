#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/time.h"

namespace rocinante {

/// Holds a link to a number of bytes a second. One datagram may be sent while there are tokens; it
/// may leave a debt, which is waited for. Reads no clock.
class TokenBucket {
 public:
  /// `burst_bytes`: what may be sent at once after silence.
  TokenBucket(double bytes_per_second, double burst_bytes, LogTime now)
      : rate_(bytes_per_second), burst_(burst_bytes), tokens_(burst_bytes), counted_(now) {}

  bool allows(LogTime now) {
    tokens_ = std::min(burst_, tokens_ + secondsOf(now - counted_) * rate_);
    counted_ = now;
    return tokens_ > 0;
  }
  void spend(std::size_t bytes) { tokens_ -= static_cast<double>(bytes); }
  /// When allows() will be true, as of the last call of it.
  LogTime allowsAt() const {
    if (tokens_ > 0) return counted_;
    return counted_ + Nanoseconds(static_cast<std::int64_t>(-tokens_ / rate_ * 1e9) + 1);
  }

 private:
  double rate_, burst_, tokens_;
  LogTime counted_;
};

}  // namespace rocinante
