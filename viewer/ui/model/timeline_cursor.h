#pragma once

#include <optional>
#include <string>

#include "core/base/playback_speed.h"
#include "core/base/time.h"

namespace rocinante {

/// The window's position on a log's time line: play, pause, scrub, speed. Pure: reads no clock. A
/// position is computed from one anchor, so an hour at any speed ends on the exact nanosecond.
class TimelineCursor {
 public:
  TimelineCursor(LogTime start, LogTime end);

  LogTime start() const { return start_; }
  LogTime end() const { return end_; }
  bool playing() const { return playing_; }
  bool looping() const { return looping_; }
  const std::string& speedText() const { return speed_text_; }

  /// The position at `now`. At the end it stops, or restarts when looping.
  LogTime position(SteadyTime now);

  /// At the end, playing restarts from the beginning.
  void play(SteadyTime now);
  void pause(SteadyTime now);
  void toggle(SteadyTime now);
  /// Clamps to the log; playing continues from there.
  void seek(LogTime moment, SteadyTime now);
  void step(Nanoseconds by, SteadyTime now);
  /// Changes the speed without a jump. Text for PlaybackSpeed::parse; false when invalid.
  bool setSpeed(const std::string& text, SteadyTime now);
  void setLooping(bool looping) { looping_ = looping; }

 private:
  void anchorAt(LogTime moment, SteadyTime now);

  LogTime start_, end_;
  LogTime anchor_log_;
  SteadyTime anchor_real_{};
  PlaybackSpeed speed_;
  std::string speed_text_ = "1";
  bool playing_ = false;
  bool looping_ = false;
};

}  // namespace rocinante
