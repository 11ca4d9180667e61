#include "core/session/log_fold.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/duration_text.h"
#include "core/log/log_profile.h"
#include "core/session/marks.h"

namespace rocinante {
namespace {

/// Folding this many messages is quicker than searching for a start.
constexpr std::uint64_t kNearMessages = 1024;
constexpr std::uint64_t kBetweenProgress = 16 * kNearMessages;
constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

}  // namespace

LogPosition lastAt(LogTime moment) { return {moment, kAll}; }

LogPosition lastBefore(LogPosition place) {
  if (place.file_offset > 0) return {place.time, place.file_offset - 1};
  return place.time == LogTime::min() ? kStartOfLog : lastAt(place.time - Nanoseconds(1));
}

LogFold::LogFold(LogReader reader) : reader_(std::move(reader)), finder_(reader_) {
  knowChannels();
}

void LogFold::knowChannels() {
  decoder_by_channel_.clear();
  for (const LogChannel& channel : reader_.channels()) {
    if (decoder_by_channel_.size() <= channel.id) decoder_by_channel_.resize(channel.id + 1U);
    decoder_by_channel_[channel.id] = folder_.decoderOf(channel);
  }
}

Result<bool> LogFold::refresh() {
  const Result<bool> grown = reader_.refresh();
  if (!grown || !*grown) return grown;
  goBehindReached();
  knowChannels();
  finder_.logGrew();
  events_found_ = false;
  // What was folded stays true only if nothing new belongs before it.
  LogPosition last = std::max(reached_, events_until_);
  if (const auto kept = cache_.last()) last = std::max(last, *kept);
  if (last != kStartOfLog && !reader_.inOrderAt(last)) startAnew();
  return true;
}

void LogFold::startAnew() {
  cache_ = {};
  events_.clear();
  events_until_ = kStartOfLog;
  startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
}

void LogFold::releaseStates() {
  cache_ = {};
  startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
}

void LogFold::startFrom(LogPosition place, SessionState from, LogPosition its_base,
                        std::uint64_t messages) {
  state_ = std::move(from);
  reached_ = place;
  base_ = its_base;
  since_base_ = messages;
  since_kept_ = 0;
  goBehindReached();
}

void LogFold::goBehindReached() {
  lookahead_.reset();
  at_end_ = false;
  placed_ = false;
}

Status LogFold::approach(LogPosition last) {
  const bool can_go_on = reached_ <= last;
  const auto* kept = cache_.nearest(last);
  std::optional<LogPosition> known;
  if (can_go_on && reached_ != kStartOfLog) known = reached_;
  if (kept != nullptr && (!known || kept->first > *known)) known = kept->first;
  // A keyframe of a moment that is folded in part is met on the way.
  const bool is_whole = last == lastAt(last.time) || last.time == LogTime::min();
  const LogTime whole = is_whole ? last.time : last.time - Nanoseconds(1);
  Result<std::optional<KeyframeFinder::Found>> found = finder_.lastBefore(whole, known);
  if (!found) return found.error();
  // The message borrowed from the reader is no longer valid.
  goBehindReached();
  if (*found) {
    cache_.keep((*found)->place, (*found)->state, (*found)->place, 0);
    startFrom((*found)->place, std::move((*found)->state), (*found)->place, 0);
  } else if (kept != nullptr && !(can_go_on && reached_ >= kept->first)) {
    startFrom(kept->first, kept->second.state, kept->second.base, kept->second.messages);
  } else if (!can_go_on) {
    startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
  }
  return {};
}

Status LogFold::reach(LogPosition last) {
  if (reached_ <= last && reached_ != kStartOfLog) {
    const Result<bool> near = foldTo(last, kNearMessages, nullptr);
    if (!near) return near.error();
    if (*near) return {};
  }
  if (Status begun = approach(last); !begun) return begun;
  if (Result<bool> folded = foldTo(last, kAll, nullptr); !folded) return folded.error();
  return {};
}

Result<const SessionState*> LogFold::stateUpTo(LogPosition last, StateDamage* damage) {
  if (Status there = reach(last); !there) return there.error();
  if (reader_.unreadable().empty()) return &state_;
  StateDamage found;
  addDamageBetween(reader_, base_, last, found);
  if (found.empty()) return &state_;
  if (damage == nullptr) {
    return Error{ErrorKind::damaged,
                 fmt::format("the state at {} s is not known: {}",
                             secondsText(last.time - reader_.summary().origin, 3), found.what()),
                 found.where()};
  }
  damage->add(found);
  return &state_;
}

Status LogFold::addDamage(LogTime from, LogTime until, StateDamage& damage) {
  if (Result<const SessionState*> begun = stateUpTo(lastAt(from), &damage); !begun) {
    return begun.error();
  }
  const LogPosition base = base_;
  goBehindReached();
  if (Status put = reader_.seek(from); !put) return put.error();
  while (true) {
    const Result<std::optional<LogMessage>> message = reader_.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time > until) break;
  }
  addDamageBetween(reader_, base, lastAt(until), damage);
  return {};
}

Result<const std::vector<Event>*> LogFold::events(
    const std::function<void(double part)>& progress) {
  if (events_found_) return &events_;
  const LogPosition end = lastAt(LogTime::max());
  if (events_until_ == kStartOfLog) {
    startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
  } else if (Status there = reach(events_until_); !there) {
    return there.error();
  }
  const std::uint64_t some = progress ? kBetweenProgress : kAll;
  const LogSummary& whole = reader_.summary();
  const auto span_s = std::max(secondsOf(whole.end - whole.start), 1e-9);
  while (true) {
    const Result<bool> folded = foldTo(end, some, &events_);
    events_until_ = reached_;  // also when it was stopped: none comes twice
    if (!folded) return folded.error();
    if (*folded) break;
    progress(std::clamp(secondsOf(reached_.time - whole.start) / span_s, 0.0, 1.0));
  }
  events_found_ = true;
  return &events_;
}

void LogFold::addHidingDamage(StateDamage& damage) const {
  if (reader_.unreadable().empty()) return;
  addDamageBetween(reader_, kStartOfLog, lastAt(reader_.summary().end), damage);
}

Result<bool> LogFold::foldTo(LogPosition last, std::uint64_t most, std::vector<Event>* sink) {
  if (!placed_) {
    const Status put = reached_ == kStartOfLog ? reader_.rewind() : reader_.seekAfter(reached_);
    if (!put) return put.error();
    placed_ = true;
  }
  for (std::uint64_t count = 0;; ++count) {
    if (!lookahead_ && !at_end_) {
      Result<std::optional<LogMessage>> message = reader_.next();
      if (!message) return message.error();
      if (*message) lookahead_ = **message;
      at_end_ = !*message;
    }
    if (at_end_ || lookahead_->place() > last) return true;
    if (count == most) return false;
    if (count % kNearMessages == 0 && stop_.stop_requested()) {
      return Error{ErrorKind::refused, "stopped", reader_.name()};
    }
    fold(*lookahead_, sink);
    lookahead_.reset();
  }
}

void LogFold::fold(const LogMessage& message, std::vector<Event>* sink) {
  reached_ = message.place();
  ++since_base_;
  ++since_kept_;
  if (finder_.isOne(message)) {
    adopt(message);
  } else if (sink != nullptr && message.channel->topic == profile::kMarkTopic) {
    if (auto mark = parseMark(message.payload)) sink->push_back({message.log_time, {}, *mark});
  } else if (Decoder* const decoder = decoder_by_channel_[message.channel->id]) {
    const Packet* const packet = decoder->decode(message.payload);
    if (packet != nullptr) foldPacket(state_, message.log_time, *packet, sink);
  }
  if (since_kept_ >= StateCache::interval(state_)) keepState();
}

void LogFold::adopt(const LogMessage& message) {
  std::optional<SessionState> keyframe = finder_.usable(message);
  if (!keyframe) return;
  state_ = std::move(*keyframe);
  base_ = reached_;
  since_base_ = 0;
  keepState();
}

void LogFold::keepState() {
  since_kept_ = 0;
  cache_.keep(reached_, state_, base_, since_base_);
}

}  // namespace rocinante
