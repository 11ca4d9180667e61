#include "core/copy/copy_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/copy/log_preceding.h"
#include "core/log/clock_message.h"
#include "core/log/log_profile.h"
#include "core/log/loss_message.h"
#include "core/log/octets_before.h"
#include "core/session/keyframe.h"
#include "core/session/marks.h"

namespace rocinante {

CopySource::CopySource(LogReader reader, Options options)
    : reader_(std::move(reader)),
      options_(std::move(options)),
      selection_(options_.selection, reader_.channels()) {}

Result<CopySource> CopySource::of(LogReader reader, Options options,
                                  std::optional<Preceding> preceding,
                                  const CopyProgress& progress) {
  CopySource source(std::move(reader), std::move(options));
  source.preceding_ = std::move(preceding);
  if (!source.preceding_) {
    if (Status found = source.findOpening(); !found) return found.error();
    // A keyframe inside the range opens the copy too.
    const TimeRange& range = source.options_.range;
    const bool inside =
        source.preceding_ && source.preceding_->moment - source.options_.shift >= range.from;
    if (range.opened() && !inside) {
      if (Status found = source.findPreceding(progress); !found) return found.error();
    }
  }
  if (Status started = source.start(); !started) return started.error();
  return source;
}

std::optional<LogTime> CopySource::origin() const {
  const LogSummary& summary = reader_.summary();
  if (summary.messages == 0 && summary.origin == LogTime{}) return std::nullopt;
  return shifted(summary.origin);
}

Status CopySource::findOpening() {
  std::string fault;
  const Result<std::optional<LogMessage>> keyframe = openingKeyframe(reader_, fault);
  if (!keyframe) return keyframe.error();
  if (!fault.empty()) notes_.push_back("cannot read an opening keyframe of the log: " + fault);
  if (!*keyframe) return {};
  const ByteView payload = (*keyframe)->payload;
  const LogTime moment = (*keyframe)->log_time;
  preceding_.emplace();
  preceding_->moment = shifted(moment);
  if (selection_.selectsAll() && options_.shift == Nanoseconds(0)) {
    Result<SessionState> whole = KeyframeReader().read(payload, moment);
    if (!whole) return whole.error();
    preceding_->state = std::move(*whole);
  } else {
    preceding_->state = wantedKeyframeState(payload, moment, selection_, options_.shift);
  }
  return {};
}

Status CopySource::findPreceding(const CopyProgress& progress) {
  const LogTime from = options_.range.from;
  const SessionState opening = preceding_ ? std::move(preceding_->state) : SessionState{};
  Result<Preceding> found =
      selection_.selectsAll() ? precedingOf(reader_.name(), from)
                              : precedingBySelection(reader_, selection_, opening, from, progress);
  if (!found) return found.error();
  preceding_ = std::move(*found);
  if (!preceding_->damage.empty()) {
    notes_.push_back("the state at the start of the piece may be outdated: " +
                     preceding_->damage.text());
  }
  if (preceding_->restatement_cut) {
    notes_.push_back("a restatement in progress at the start of the piece was cut off");
  }
  return {};
}

Status CopySource::start() {
  const TimeRange& range = options_.range;
  for (const LossSpan& loss : reader_.losses()) {
    if (range.opened() && loss.until <= range.from) continue;
    if (range.ended() && loss.until > range.until) continue;
    losses_.push_back(loss);
    losses_.back().from = shifted(loss.from);
    losses_.back().until = shifted(loss.until);
  }
  std::ranges::stable_sort(losses_, {}, &LossSpan::until);
  std::erase_if(options_.marks, [&](const Event& mark) { return !range.holds(mark.time); });
  for (Event& mark : options_.marks) mark.time = shifted(mark.time);
  opening_given_ = !preceding_ || preceding_->state.sources().empty();
  if (preceding_ && preceding_->lead) return reader_.seek(preceding_->lead->time);
  return range.opened() ? reader_.seek(range.from) : reader_.rewind();
}

/// Fills message_ with the next wanted one.
Status CopySource::takeMessage() {
  while (!message_ && !at_end_) {
    std::optional<LogMessage> read = std::exchange(behind_, std::nullopt);
    if (!read) {
      const Result<std::optional<LogMessage>> next = reader_.next();
      if (!next) return next.error();
      read = *next;
    }
    if (!read || read->log_time >= options_.range.until) {
      at_end_ = true;
      return {};
    }
    const LogMessage message = *read;
    const std::string& topic = message.channel->topic;
    // Keyframes are made again, and losses come from reader().losses().
    if (topic == profile::kKeyframeTopic || topic == profile::kLossTopic) continue;
    message_is_lead_ = message.log_time < options_.range.from;
    if (message_is_lead_) {
      if (!preceding_ || !preceding_->lead || message.place() <= *preceding_->lead) continue;
      if (!message.channel->folded()) continue;
    }
    if (selection_.waitsForPacket(message)) {
      if (Status taken = takeOctetsIfWanted(message); !taken) return taken;
    } else if (selection_.includes(message)) {
      message_ = message;
    }
  }
  return {};
}

/// The packet behind the octets decides about both.
Status CopySource::takeOctetsIfWanted(const LogMessage& octets) {
  OctetsBefore before;
  before.take(octets);
  octets_payload_.assign(octets.payload.begin(), octets.payload.end());
  const Result<std::optional<LogMessage>> next = reader_.next();
  if (!next) return next.error();
  behind_ = *next;
  if (!behind_) {
    at_end_ = true;
    return {};
  }
  if (!before.areOf(*behind_) || !selection_.includes(*behind_)) return {};
  message_ = octets;
  message_->payload = octets_payload_;
  return {};
}

Result<const CopyItem*> CopySource::peek() {
  if (has_item_) return &item_;
  while (true) {
    if (Status taken = takeMessage(); !taken) return taken.error();
    chooseItem();
    if (!has_item_) return nullptr;
    if (item_.kind != CopyItem::Kind::mark) return &item_;
    if (item_.time != given_marks_time_) given_marks_.clear();
    given_marks_time_ = item_.time;
    if (std::ranges::find(given_marks_, item_.mark->text) == given_marks_.end()) {
      given_marks_.push_back(item_.mark->text);
      return &item_;
    }
    pop();
  }
}

void CopySource::chooseItem() {
  item_ = CopyItem{};
  has_item_ = true;
  const LossSpan* const loss = next_loss_ < losses_.size() ? &losses_[next_loss_] : nullptr;
  const Event* const mark =
      next_mark_ < options_.marks.size() ? &options_.marks[next_mark_] : nullptr;
  const LogTime kNever = LogTime::max();
  const LogTime message_time = message_ ? shifted(message_->log_time) : kNever;
  if (!opening_given_) {
    item_.kind = CopyItem::Kind::opening;
    item_.preceding = &*preceding_;
    item_.time = preceding_->moment;
  } else if (loss != nullptr && loss->until <= message_time &&
             (mark == nullptr || loss->until <= mark->time)) {
    item_.kind = CopyItem::Kind::loss;
    item_.loss = loss;
    item_.time = loss->until;
  } else if (mark != nullptr && mark->time < message_time) {
    item_.kind = CopyItem::Kind::mark;
    item_.mark = mark;
    item_.time = mark->time;
  } else if (message_) {
    item_.kind = message_is_lead_ ? CopyItem::Kind::lead : CopyItem::Kind::message;
    item_.time = message_time;
    item_.message = *message_;
    item_.publish_time_ns =
        message_->publish_time_ns + (options_.shift_publish ? options_.shift.count() : 0);
    if (message_->channel->topic == profile::kClockTopic && options_.shift != Nanoseconds(0)) {
      if (std::optional<std::string> text = shiftedClockText(message_->payload, options_.shift)) {
        moved_payload_ = std::move(*text);
        item_.message.payload = bytesOf(moved_payload_);
      }
    }
    if (message_->channel->topic == profile::kMarkTopic) {
      if (std::optional<std::string> text = parseMark(message_->payload)) {
        baked_mark_ = Event{message_time, {}, std::move(*text)};
        item_.kind = CopyItem::Kind::mark;
        item_.mark = &baked_mark_;
      }
    }
  } else {
    has_item_ = false;
  }
}

void CopySource::pop() {
  has_item_ = false;
  switch (item_.kind) {
    case CopyItem::Kind::opening:
      opening_given_ = true;
      return;
    case CopyItem::Kind::loss:
      ++next_loss_;
      return;
    case CopyItem::Kind::mark:
      if (item_.mark != &baked_mark_) {
        ++next_mark_;
        return;
      }
      [[fallthrough]];
    case CopyItem::Kind::lead:
    case CopyItem::Kind::message:
      message_.reset();
      return;
  }
}

}  // namespace rocinante
