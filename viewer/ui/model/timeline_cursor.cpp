#include "viewer/ui/model/timeline_cursor.h"

#include <algorithm>

namespace rocinante {

TimelineCursor::TimelineCursor(LogTime start, LogTime end)
    : start_(start), end_(std::max(start, end)), anchor_log_(start) {}

void TimelineCursor::anchorAt(LogTime moment, SteadyTime now) {
  anchor_log_ = std::clamp(moment, start_, end_);
  anchor_real_ = now;
}

LogTime TimelineCursor::position(SteadyTime now) {
  if (!playing_) return anchor_log_;
  const LogTime moment = anchor_log_ + speed_.logDuration(now - anchor_real_);
  if (moment < end_) return std::max(moment, start_);
  if (looping_ && end_ > start_) {
    const Nanoseconds turn = (moment - start_) % (end_ - start_);
    anchorAt(start_ + turn, now);
    return anchor_log_;
  }
  anchorAt(end_, now);
  playing_ = false;
  return end_;
}

void TimelineCursor::play(SteadyTime now) {
  if (playing_) return;
  anchorAt(anchor_log_ >= end_ ? start_ : anchor_log_, now);
  playing_ = true;
}

void TimelineCursor::pause(SteadyTime now) {
  if (!playing_) return;
  anchorAt(position(now), now);
  playing_ = false;
}

void TimelineCursor::toggle(SteadyTime now) { playing_ ? pause(now) : play(now); }

void TimelineCursor::seek(LogTime moment, SteadyTime now) { anchorAt(moment, now); }

void TimelineCursor::step(Nanoseconds by, SteadyTime now) {
  pause(now);
  anchorAt(anchor_log_ + by, now);
}

bool TimelineCursor::setSpeed(const std::string& text, SteadyTime now) {
  const auto speed = PlaybackSpeed::parse(text);
  if (!speed.ok()) return false;
  anchorAt(position(now), now);
  speed_ = *speed;
  speed_text_ = text;
  return true;
}

}  // namespace rocinante
