#include "recorder/gltf/key_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kBlockNumbers = 1024;
constexpr std::size_t kBlockBytes = kBlockNumbers * sizeof(float);

/// Metres and parts of a quaternion that are no motion: the noise of rounding to float.
constexpr float kNoise = 1e-7F;
constexpr double kMaxBlendSeconds = 1.0;
/// Metres. A float holds 1,024 m to 0.06 mm, and multiples of 1,024 m up to 17 million km exactly.
constexpr double kOffsetStep = 1024;

}  // namespace

Result<KeySpill> KeySpill::make(const std::string& folder) {
  Result<UnnamedFile> file = UnnamedFile::make(folder);
  if (!file) return file.error();
  return KeySpill(std::move(*file));
}

std::size_t KeySpill::addList() {
  lists_.emplace_back();
  return lists_.size() - 1;
}

Status KeySpill::append(std::size_t list, std::span<const float> numbers) {
  List& to = lists_[list];
  while (!numbers.empty()) {
    const std::size_t room = std::min(kBlockNumbers - to.open.size(), numbers.size());
    to.open.insert(to.open.end(), numbers.begin(),
                   numbers.begin() + static_cast<std::ptrdiff_t>(room));
    numbers = numbers.subspan(room);
    if (to.open.size() < kBlockNumbers) continue;
    if (Status written = writeBlock(to); !written) return written;
  }
  return {};
}

Status KeySpill::writeBlock(List& list) {
  Status written = file_.write(blocks_ * kBlockBytes, std::as_bytes(std::span(list.open)));
  if (!written) return written;
  list.blocks.push_back(blocks_++);
  list.open.clear();
  return {};
}

std::uint64_t KeySpill::bytesOf(std::size_t list) const {
  const List& of = lists_[list];
  return of.blocks.size() * kBlockBytes + of.open.size() * sizeof(float);
}

Status KeySpill::read(std::size_t list, const std::function<Status(ByteView)>& use) const {
  std::array<std::byte, kBlockBytes> bytes;
  for (const std::uint64_t block : lists_[list].blocks) {
    if (Status filled = file_.read(block * kBlockBytes, bytes); !filled) return filled;
    if (Status used = use(bytes); !used) return used;
  }
  const std::vector<float>& open = lists_[list].open;
  return open.empty() ? Status{} : use(std::as_bytes(std::span(open)));
}

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
