#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/base/playback_speed.h"
#include "core/base/time.h"

namespace rocinante {

/// What happens where playing would end.
enum class Repeat : std::uint8_t {
  once,            ///< it stops
  loop,            ///< it restarts at the other end
  there_and_back,  ///< it turns round
};

/// The window's position on a log's time line: play, pause, scrub, speed, direction, and a part of
/// the log to repeat. Pure: reads no clock. A position is computed from one anchor, so an hour at
/// any speed ends on the exact nanosecond.
class TimelineCursor {
 public:
  TimelineCursor(LogTime start, LogTime end);

  LogTime start() const { return start_; }
  LogTime end() const { return end_; }
  /// The picture moves by itself: it plays, or follows now.
  bool playing() const { return playing_ || following_; }
  bool looping() const { return repeat_ != Repeat::once; }
  Repeat repeat() const { return repeat_; }
  bool reversed() const { return reversed_; }
  /// The part that is repeated: the log, or what setPart() chose.
  LogTime partStart() const { return part_ ? part_->first : start_; }
  LogTime partEnd() const { return part_ ? part_->second : end_; }
  bool hasPart() const { return part_.has_value(); }
  const std::string& speedText() const { return speed_text_; }

  /// The log has changed its length.
  void resize(LogTime start, LogTime end);
  /// While the log grows its end is now, and playing into the end continues there.
  void setGrowing(bool growing);
  /// Goes to now and stays there, until anything else moves the position. For a growing log.
  void followNow();
  bool following() const { return following_; }

  /// The position at `now`. Where playing ends it stops, restarts, turns round, or follows a
  /// growing log; when repeating, a position outside the part moves into it.
  LogTime position(SteadyTime now);

  /// At the end, playing restarts from the beginning; reversed, the other way round. Of a growing
  /// log, it follows now.
  void play(SteadyTime now);
  void pause(SteadyTime now);
  void toggle(SteadyTime now);
  /// Clamps to the log; playing continues from there.
  void seek(LogTime moment, SteadyTime now);
  void step(Nanoseconds by, SteadyTime now);
  /// Changes the speed without a jump. Text for PlaybackSpeed::parse; false when invalid.
  bool setSpeed(const std::string& text, SteadyTime now);
  void setLooping(bool looping) { repeat_ = looping ? Repeat::loop : Repeat::once; }
  void setRepeat(Repeat repeat, SteadyTime now);
  void setReversed(bool reversed, SteadyTime now);
  /// Repeats from one moment to another, in either order, clamped to the log; a part without length
  /// is the whole log. The repetition is that of before, or a loop.
  void setPart(LogTime from, LogTime until, SteadyTime now);
  void clearPart(SteadyTime now);

 private:
  void anchorAt(LogTime moment, SteadyTime now);
  LogTime repeatedPosition(Nanoseconds played, SteadyTime now);
  /// At the end of a growing log, where it continues as if it had played to there.
  void leaveNow(SteadyTime now);
  bool isSlow() const;

  LogTime start_, end_;
  LogTime anchor_log_;
  SteadyTime anchor_real_{};
  PlaybackSpeed speed_;
  std::string speed_text_ = "1";
  bool playing_ = false;
  bool reversed_ = false;
  Repeat repeat_ = Repeat::once;
  std::optional<std::pair<LogTime, LogTime>> part_;
  bool growing_ = false;
  bool following_ = false;
};

}  // namespace rocinante
