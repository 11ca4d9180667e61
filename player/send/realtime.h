#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// Whether a thread that paces asks to run before all others.
enum class Realtime : std::uint8_t {
  automatic,  ///< when the system permits it, silently without
  on,         ///< or fail
  off,
};

/// "auto", "on" and "off", as options write them; anything else is automatic.
Realtime realtimeOf(std::string_view text);

/// Makes the calling thread fit for pacing while it lives: timers without slack, short slices and,
/// when permitted, SCHED_FIFO (not for threads started from it). One at a time; belongs to the
/// thread that made it.
class PacingThread {
 public:
  /// refused when `realtime` is `on` and the system does not permit it.
  static Result<PacingThread> begin(Realtime realtime);
  ~PacingThread();
  PacingThread(PacingThread&& other) noexcept;
  PacingThread& operator=(PacingThread&& other) = delete;

  bool isRealtime() const { return realtime_; }
  /// Back to ordinary scheduling: a real-time thread that never sleeps starves its machine, and is
  /// stopped by the kernel for 50 ms of each second.
  void leaveRealtime();

 private:
  PacingThread() = default;

  bool owner_ = true;
  bool realtime_ = false;
  int former_slack_ns_ = 0;
};

}  // namespace rocinante
