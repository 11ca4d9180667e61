#include "viewer/ui/model/timeline_cursor.h"

#include <algorithm>

namespace rocinante {

TimelineCursor::TimelineCursor(LogTime start, LogTime end)
    : start_(start), end_(std::max(start, end)), anchor_log_(start) {}

void TimelineCursor::anchorAt(LogTime moment, SteadyTime now) {
  anchor_log_ = std::clamp(moment, start_, end_);
  anchor_real_ = now;
}

void TimelineCursor::resize(LogTime start, LogTime end) {
  start_ = start;
  end_ = std::max(start, end);
  // What the recorder has deleted cannot be shown.
  if (!playing_) anchor_log_ = std::clamp(anchor_log_, start_, end_);
  if (!part_) return;
  part_ =
      std::pair(std::clamp(part_->first, start_, end_), std::clamp(part_->second, start_, end_));
  if (part_->first == part_->second) part_.reset();
}

void TimelineCursor::setGrowing(bool growing) {
  growing_ = growing;
  if (growing || !following_) return;
  following_ = false;
  anchor_log_ = end_;
}

void TimelineCursor::followNow() {
  if (!growing_) return;
  following_ = true;
  playing_ = false;
}

void TimelineCursor::leaveNow(SteadyTime now) {
  if (!following_) return;
  following_ = false;
  playing_ = true;
  anchorAt(end_, now);
}

LogTime TimelineCursor::position(SteadyTime now) {
  if (following_) return end_;
  if (!playing_) return anchor_log_;
  const Nanoseconds played = speed_.logDuration(now - anchor_real_);
  if (looping() && partEnd() > partStart()) return repeatedPosition(played, now);
  // Compared as lengths: a moment far beyond the log may not be a time.
  const Nanoseconds room = reversed_ ? anchor_log_ - start_ : end_ - anchor_log_;
  if (played < room) {
    return std::max(reversed_ ? anchor_log_ - played : anchor_log_ + played, start_);
  }
  anchorAt(reversed_ ? start_ : end_, now);
  // Slow motion waits for the log to grow: it cannot keep up with it.
  if (growing_ && !reversed_ && isSlow()) return end_;
  playing_ = false;
  if (!reversed_) followNow();
  return reversed_ ? start_ : end_;
}

/// While nothing turns round, the anchor stays, so that no rounding adds up.
LogTime TimelineCursor::repeatedPosition(Nanoseconds played, SteadyTime now) {
  const LogTime first = partStart(), last = partEnd();
  const Nanoseconds length = last - first;
  if (anchor_log_ < first || anchor_log_ > last) {
    anchorAt(reversed_ ? last : first, now);
    return anchor_log_;
  }
  const Nanoseconds behind = reversed_ ? last - anchor_log_ : anchor_log_ - first;
  if (played < length - behind) return reversed_ ? anchor_log_ - played : anchor_log_ + played;
  // Beyond the end: by how much, in turns of the part.
  const Nanoseconds beyond = played - (length - behind);
  const Nanoseconds into = beyond % length;
  const bool odd = beyond / length % 2 == 1;
  const bool turned = repeat_ == Repeat::there_and_back && !odd;
  if (turned) reversed_ = !reversed_;
  anchorAt(reversed_ ? last - into : first + into, now);
  return anchor_log_;
}

void TimelineCursor::setRepeat(Repeat repeat, SteadyTime now) {
  anchorAt(position(now), now);
  repeat_ = repeat;
}

void TimelineCursor::setReversed(bool reversed, SteadyTime now) {
  if (reversed) leaveNow(now);
  anchorAt(position(now), now);
  reversed_ = reversed;
}

void TimelineCursor::setPart(LogTime from, LogTime until, SteadyTime now) {
  leaveNow(now);
  anchorAt(position(now), now);
  from = std::clamp(from, start_, end_);
  until = std::clamp(until, start_, end_);
  part_.reset();
  if (from == until) return;
  part_ = std::minmax(from, until);
  if (repeat_ == Repeat::once) repeat_ = Repeat::loop;
}

void TimelineCursor::clearPart(SteadyTime now) {
  anchorAt(position(now), now);
  part_.reset();
}

void TimelineCursor::play(SteadyTime now) {
  if (playing()) return;
  const bool at_stop = reversed_ ? anchor_log_ <= start_ : anchor_log_ >= end_;
  if (growing_ && !reversed_ && at_stop && !looping() && !isSlow()) return followNow();
  const bool restarts = at_stop && (reversed_ || !growing_);
  anchorAt(restarts ? (reversed_ ? end_ : start_) : anchor_log_, now);
  playing_ = true;
}

bool TimelineCursor::isSlow() const {
  return speed_.logDuration(std::chrono::seconds(1)) < std::chrono::seconds(1);
}

void TimelineCursor::pause(SteadyTime now) {
  if (following_) {
    following_ = false;
    return anchorAt(end_, now);
  }
  if (!playing_) return;
  anchorAt(position(now), now);
  playing_ = false;
}

void TimelineCursor::toggle(SteadyTime now) { playing() ? pause(now) : play(now); }

void TimelineCursor::seek(LogTime moment, SteadyTime now) {
  leaveNow(now);
  anchorAt(moment, now);
}

void TimelineCursor::step(Nanoseconds by, SteadyTime now) {
  pause(now);
  anchorAt(anchor_log_ + by, now);
}

bool TimelineCursor::setSpeed(const std::string& text, SteadyTime now) {
  const auto speed = PlaybackSpeed::parse(text);
  if (!speed.ok()) return false;
  if (!following_) anchorAt(position(now), now);
  speed_ = *speed;
  // Now itself has one speed: slow motion falls behind.
  if (following_ && isSlow()) leaveNow(now);
  speed_text_ = text;
  return true;
}

}  // namespace rocinante
