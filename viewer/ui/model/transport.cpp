#include "viewer/ui/model/transport.h"

#include <algorithm>

namespace rocinante {

Transport::Transport(LogTime start, LogTime end)
    : start_(start), end_(std::max(start, end)), anchor_log_(start) {}

void Transport::anchorAt(LogTime moment, SteadyTime now) {
  anchor_log_ = std::clamp(moment, start_, end_);
  anchor_real_ = now;
}

LogTime Transport::position(SteadyTime now) {
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

void Transport::play(SteadyTime now) {
  if (playing_) return;
  anchorAt(anchor_log_ >= end_ ? start_ : anchor_log_, now);
  playing_ = true;
}

void Transport::pause(SteadyTime now) {
  if (!playing_) return;
  anchorAt(position(now), now);
  playing_ = false;
}

void Transport::toggle(SteadyTime now) { playing_ ? pause(now) : play(now); }

void Transport::seek(LogTime moment, SteadyTime now) { anchorAt(moment, now); }

void Transport::step(Nanoseconds by, SteadyTime now) {
  pause(now);
  anchorAt(anchor_log_ + by, now);
}

bool Transport::setSpeed(const std::string& text, SteadyTime now) {
  const auto speed = PlaybackSpeed::parse(text);
  if (!speed.ok()) return false;
  anchorAt(position(now), now);
  speed_ = *speed;
  speed_text_ = text;
  return true;
}

}  // namespace rocinante
