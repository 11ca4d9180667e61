#include "core/session/keyframe_finder.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

/// After this many unusable keyframes in a row, the log is read from further back.
constexpr int kMaxTries = 16;

/// At most this many are reported: a hostile log could have millions.
constexpr std::size_t kMaxFaults = 100;

}  // namespace

KeyframeFinder::KeyframeFinder(LogReader& reader) : reader_(reader) { findChannel(); }

void KeyframeFinder::logGrew() {
  known_.clear();
  findChannel();
}

void KeyframeFinder::findChannel() {
  std::size_t count = 0;
  for (const LogChannel& channel : reader_.channels()) {
    if (!isKeyframeChannel(channel)) continue;
    channel_ = channel.id;
    ++count;
  }
  if (count > 1) {
    // The logs were merged by a tool that ignores keyframes: each keyframe has part of the state.
    channel_.reset();
    if (std::exchange(several_reported_, true)) return;
    faults_.push_back({reader_.summary().start,
                       "the log has several keyframe channels, so none of them is used"});
  }
}

std::optional<SessionState> KeyframeFinder::usable(const LogMessage& message) {
  if (refused_.contains(message.place())) return std::nullopt;
  Result<SessionState> read = keyframes_.read(message.payload, message.log_time);
  if (!read) {
    refuse(message, read.error().what);
    return std::nullopt;
  }
  if (!reader_.inOrderAt(message.place())) {
    refuse(message, "a message after it in the file sorts before it");
    return std::nullopt;
  }
  return std::move(*read);
}

void KeyframeFinder::refuse(const LogMessage& message, std::string cause) {
  refused_.insert(message.place());
  if (faults_.size() < kMaxFaults) faults_.push_back({message.log_time, std::move(cause)});
}

Result<std::optional<KeyframeFinder::Found>> KeyframeFinder::lastBefore(
    LogTime moment, const std::optional<LogPosition>& known) {
  if (!channel_) return std::optional<Found>();
  if (const auto later = known_.upper_bound(moment); later != known_.begin()) {
    const Known& before = std::prev(later)->second;
    const bool is_no_better = !before.place || (known && *known >= *before.place);
    if (moment <= before.until && is_no_better) return std::optional<Found>();
  }
  LogTime from = moment;
  for (int tries = 0; tries < kMaxTries; ++tries) {
    Result<std::optional<LogMessage>> last = reader_.lastOf(*channel_, from);
    if (!last) return last.error();
    if (!*last) {
      remember(std::nullopt, moment);
      break;
    }
    const LogMessage& message = **last;
    if (known && *known >= message.place()) {
      // Only the first result covers the time between it and the moment.
      if (tries == 0) remember(message.place(), moment);
      break;
    }
    const LogPosition place = message.place();
    if (std::optional<SessionState> state = usable(message)) {
      remember(place, moment);
      return std::optional<Found>({place, std::move(*state)});
    }
    if (place.time == LogTime::min()) break;
    from = place.time - Nanoseconds(1);
  }
  return std::optional<Found>();
}

void KeyframeFinder::remember(std::optional<LogPosition> place, LogTime moment) {
  Known& known = known_[place ? place->time : LogTime::min()];
  known.place = place;
  known.until = std::max(known.until, moment);
}

}  // namespace rocinante
