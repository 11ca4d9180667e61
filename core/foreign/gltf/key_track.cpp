#include "core/foreign/gltf/key_track.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

/// Metres and parts of a quaternion that are no motion: the noise of rounding to float.
constexpr float kNoise = 1e-7F;
constexpr double kMaxBlendSeconds = 1.0;
/// Metres. A float holds 1,024 m to 0.06 mm, and multiples of 1,024 m up to 17 million km exactly.
constexpr double kOffsetStep = 1024;

}  // namespace

bool KeyTrack::isSame(const Value& value) const {
  for (std::size_t i = 0; i < width(); ++i) {
    if (std::abs(value[i] - key_[i]) > kNoise) return false;
  }
  return true;
}

void KeyTrack::chooseOffset(std::span<const double> value) {
  if (kind_ != Kind::translation) return;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (!(std::abs(value[i]) > kOffsetStep)) continue;
    offset_[i] = static_cast<float>(std::round(value[i] / kOffsetStep) * kOffsetStep);
    if (!std::isfinite(offset_[i])) offset_[i] = 0;
  }
}

KeyTrack::Value KeyTrack::rounded(std::span<const double> value) {
  Value now{};
  for (std::size_t i = 0; i < width(); ++i) {
    if (kind_ != Kind::translation) {
      now[i] = static_cast<float>(value[i]);
      continue;
    }
    const double inner = value[i] - offset_[i];
    now[i] = static_cast<float>(inner);
    worst_error_ = std::max(worst_error_, std::abs(now[i] - inner));
  }
  return now;
}

Status KeyTrack::add(KeySpill& spill, double seconds, std::span<const double> value) {
  if (empty()) chooseOffset(value);
  Value now = rounded(value);
  if (empty()) {
    first_ = key_ = now;
    first_time_ = key_time_ = static_cast<float>(seconds);
    seen_s_ = key_s_ = seconds;
    return {};
  }
  if (kind_ == Kind::rotation) {
    // A quaternion and its negative turn alike, but a blend between them takes the long way.
    float likeness = 0;
    for (std::size_t i = 0; i < 4; ++i) likeness += now[i] * key_[i];
    if (likeness < 0) {
      for (float& part : now) part = -part;
    }
  }
  if (isSame(now)) {
    seen_s_ = seconds;
    return {};
  }
  if (kind_ != Kind::scale) {
    const double holds_until = std::max(seen_s_, seconds - kMaxBlendSeconds);
    if (Status held = setKey(spill, holds_until, key_); !held) return held;
  }
  if (seconds > key_s_ && static_cast<float>(seconds) <= key_time_) ++merged_;
  seen_s_ = key_s_ = seconds;
  return setKey(spill, seconds, now);
}

Status KeyTrack::setKey(KeySpill& spill, double seconds, const Value& value) {
  // Times increase strictly; two moments that a float does not tell apart are one, the later.
  const auto time = static_cast<float>(seconds);
  if (time > key_time_) {
    if (Status written = writeKey(spill); !written) return written;
    key_time_ = time;
  }
  key_ = value;
  return {};
}

Status KeyTrack::writeKey(KeySpill& spill) {
  if (!lists_) {
    const std::size_t times = spill.addList();
    lists_ = {times, spill.addList()};
  }
  ++keys_;
  if (Status timed = spill.append(lists_->first, {&key_time_, 1}); !timed) return timed;
  return spill.append(lists_->second, std::span(key_).first(width()));
}

Status KeyTrack::end(KeySpill& spill) {
  if (!lists_) {
    // One moment in all: what holds then.
    if (!empty()) first_ = key_;
    return {};
  }
  return writeKey(spill);
}

}  // namespace rocinante
