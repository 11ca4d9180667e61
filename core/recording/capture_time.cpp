#include "core/recording/capture_time.h"

#include <algorithm>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// Well below the limit of 64-bit nanoseconds, so that adding a little cannot overflow.
constexpr Nanoseconds kLatest = std::chrono::seconds(9'200'000'000);

}  // namespace

LogTime CaptureTime::at(WallTime stamp) {
  // Log times lie between 1970 and kLatest. A clock that is set back again and again would exceed
  // it.
  const Nanoseconds since = std::clamp(stamp.time_since_epoch(), Nanoseconds(0), kLatest);
  const LogTime seen(std::min(since, kLatest - shift_) + shift_);
  if (!reached_) reached_ = seen;
  if (seen + kDisorder < *reached_) {
    step_ = ClockStep{*reached_, seen - *reached_};
    shift_ += *reached_ - seen;
    return *reached_;
  }
  if (seen < *reached_) {
    ++raised_;
    most_raised_ = std::max(most_raised_, *reached_ - seen);
  }
  reached_ = std::max(*reached_, seen);
  return *reached_;
}

Account CaptureTime::leftOut() const {
  Account account;
  if (raised_ == 0) return account;
  account.leaveOut({.kind = "time",
                    .reason = "before that of the datagram in front, by at most " +
                              secondsText(most_raised_) + " s: raised to it",
                    .count = raised_});
  return account;
}

}  // namespace rocinante
