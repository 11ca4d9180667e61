#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/time.h"
#include "player/playhead/play_status.h"

namespace rocinante {

/// A terminal line with the player's position, five times a second, from its own thread: a slow
/// terminal must not delay a deadline. Counts down in a long silence.
class PlayLine {
 public:
  /// `status` must outlive the line. Draws only when `visible`, on stderr.
  PlayLine(const PlayStatus& status, LogTime origin, LogTime end, bool visible);
  /// Clears the line.
  ~PlayLine();
  PlayLine(const PlayLine&) = delete;
  PlayLine& operator=(const PlayLine&) = delete;

  /// The text of the line at `now`.
  static std::string text(const PlayStatus& status, LogTime origin, LogTime end, SteadyTime now);

 private:
  void drawUntilStopped();

  const PlayStatus& status_;
  LogTime origin_, end_;
  std::mutex mutex_;
  std::condition_variable stopping_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rocinante
