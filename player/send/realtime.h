#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// Whether a pacing thread asks for real-time scheduling.
enum class Realtime : std::uint8_t {
  automatic,  ///< if the system permits it; silently without
  on,         ///< or fail
  off,
};

/// Parses "auto", "on" and "off"; anything else is automatic.
Realtime realtimeOf(std::string_view text);

/// Prepares the calling thread for pacing during its lifetime: timers without slack, short slices
/// and, when permitted, SCHED_FIFO (not inherited by threads it starts). One at a time; for the
/// thread that made it.
class PacingThread {
 public:
  /// refused when `realtime` is `on` and the system does not permit it.
  static Result<PacingThread> begin(Realtime realtime);
  ~PacingThread();
  PacingThread(PacingThread&& other) noexcept;
  PacingThread& operator=(PacingThread&& other) = delete;

  bool isRealtime() const { return realtime_; }
  /// Returns to ordinary scheduling: a real-time thread that never sleeps starves the machine, and
  /// the kernel stops it for 50 ms of each second.
  void leaveRealtime();

 private:
  PacingThread() = default;

  bool owner_ = true;
  bool realtime_ = false;
  int former_slack_ns_ = 0;
};

}  // namespace rocinante
