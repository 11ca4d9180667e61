#include "core/log/span_merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/log/mcap_stream_reader.h"

namespace rocinante {
namespace {

/// What expanded spans may hold together before those that wait are let go.
constexpr std::size_t kHeldBytes = std::size_t{64} << 20U;
/// Memory kept for the next span: more is given back.
constexpr std::size_t kSpareBytes = std::size_t{8} << 20U;
constexpr std::size_t kSpares = 3;

std::int64_t nanosecondsOf(LogTime time) { return time.time_since_epoch().count(); }

std::uint64_t orderOf(std::uint32_t span, std::uint32_t offset) {
  return (std::uint64_t{span} << 32U) | offset;
}

}  // namespace

SpanMerge::SpanMerge(ByteView file, const std::vector<MessageSpan>& spans,
                     const std::vector<const LogChannel*>& channels,
                     std::vector<DamageSpan>& damage)
    : spans_(spans),
      channels_(channels),
      damage_(damage),
      decoder_(file),
      by_start_(spans.size()),
      reported_(spans.size(), false),
      from_ns_(std::numeric_limits<std::int64_t>::min()) {
  std::iota(by_start_.begin(), by_start_.end(), 0U);
  // Stable: spans that start together stay in the file's order.
  std::ranges::stable_sort(by_start_, {}, [&](std::uint32_t i) { return spans_[i].start_time; });
  std::int64_t latest = std::numeric_limits<std::int64_t>::min();
  for (const std::uint32_t i : by_start_) {
    latest = std::max(latest, nanosecondsOf(spans_[i].end_time));
    latest_end_.push_back(latest);
  }
}

void SpanMerge::seek(LogTime moment) {
  for (Open& open : open_) recycle(std::move(open.messages));
  open_.clear();
  given_ = false;
  from_ns_ = nanosecondsOf(moment);
  // Everything before this ends before the moment.
  const auto first = std::ranges::lower_bound(latest_end_, from_ns_);
  next_span_ = static_cast<std::size_t>(first - latest_end_.begin());
}

void SpanMerge::recycle(std::unique_ptr<SpanMessages> messages) {
  if (messages && spare_.size() < kSpares && messages->heldBytes() <= kSpareBytes) {
    spare_.push_back(std::move(messages));
  }
}

std::unique_ptr<SpanMessages> SpanMerge::load(std::uint32_t span) {
  std::unique_ptr<SpanMessages> messages;
  if (spare_.empty()) {
    messages = std::make_unique<SpanMessages>();
  } else {
    messages = std::move(spare_.back());
    spare_.pop_back();
  }
  decoder_.decode(spans_[span], *messages);
  report(span, *messages);
  return messages;
}

/// Lists the span's damage when it is first read, and leaves out messages on unknown channels.
void SpanMerge::report(std::uint32_t span, SpanMessages& messages) {
  const auto unknown = [&](const SpanMessages::Place& place) {
    return place.channel >= channels_.size() || channels_[place.channel] == nullptr;
  };
  const std::size_t orphans = std::erase_if(messages.places, unknown);
  if (reported_[span]) return;
  reported_[span] = true;
  const MessageSpan& where = spans_[span];
  std::ranges::copy(messages.damage, std::back_inserter(damage_));
  if (orphans > 0) {
    damage_.push_back({where.offset, where.end,
                       fmt::format("{} messages are on a channel that nothing defines", orphans),
                       std::uint64_t{orphans}});
  }
  for (const mcap::Channel& channel : messages.channels) {
    const LogChannel* const known = channel.id < channels_.size() ? channels_[channel.id] : nullptr;
    if (known == nullptr || known->topic != channel.topic ||
        known->encoding != channel.message_encoding || known->metadata != channel.metadata) {
      damage_.push_back({where.offset, where.end,
                         fmt::format("channel {} is defined again as another", channel.id),
                         std::nullopt});
    }
  }
  if (messages.places.empty()) return;
  if (messages.places.front().time_ns < nanosecondsOf(where.start_time) ||
      messages.places.back().time_ns > nanosecondsOf(where.end_time)) {
    damage_.push_back({where.offset, where.end,
                       "a chunk holds messages outside the times that its index gives",
                       std::uint64_t{0}});
  }
}

void SpanMerge::openNextSpan() {
  const std::uint32_t span = by_start_[next_span_++];
  if (nanosecondsOf(spans_[span].end_time) < from_ns_) return;
  Open open;
  open.span = span;
  open.messages = load(span);
  const std::vector<SpanMessages::Place>& places = open.messages->places;
  const auto first = std::ranges::lower_bound(places, from_ns_, {}, &SpanMessages::Place::time_ns);
  if (first == places.end()) {
    recycle(std::move(open.messages));
    return;
  }
  open.at = static_cast<std::size_t>(first - places.begin());
  open.time_ns = first->time_ns;
  open.order = orderOf(span, first->offset);
  open_.push_back(std::move(open));
  std::ranges::push_heap(open_, Later{});
  letOthersGo();
}

void SpanMerge::letOthersGo() {
  if (open_.size() < 2) return;
  std::size_t held = 0;
  for (const Open& open : open_) held += open.messages ? open.messages->heldBytes() : 0;
  if (held <= kHeldBytes) return;
  for (std::size_t i = 1; i < open_.size(); ++i) open_[i].messages.reset();
}

void SpanMerge::advance() {
  given_ = false;
  Open& first = open_.front();
  const std::vector<SpanMessages::Place>& places = first.messages->places;
  if (++first.at < places.size()) {
    first.time_ns = places[first.at].time_ns;
    first.order = orderOf(first.span, places[first.at].offset);
    if (open_.size() == 1) return;
    std::ranges::pop_heap(open_, Later{});
    std::ranges::push_heap(open_, Later{});
    return;
  }
  std::ranges::pop_heap(open_, Later{});
  recycle(std::move(open_.back().messages));
  open_.pop_back();
}

std::optional<LogMessage> SpanMerge::next() {
  if (given_) advance();
  while (next_span_ < by_start_.size() &&
         (open_.empty() ||
          nanosecondsOf(spans_[by_start_[next_span_]].start_time) <= open_.front().time_ns)) {
    openNextSpan();
  }
  if (open_.empty()) return std::nullopt;
  Open& first = open_.front();
  if (!first.messages) {
    // Its place is found again by what it had next.
    first.messages = load(first.span);
    const SpanMessages::Place wanted{first.time_ns, static_cast<std::uint32_t>(first.order), 0};
    const std::vector<SpanMessages::Place>& places = first.messages->places;
    first.at = static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), wanted) -
                                        places.begin());
    letOthersGo();
  }
  const SpanMessages::Place& place = first.messages->places[first.at];
  const std::optional<mcap::Record> record = mcap::recordAt(first.messages->records, place.offset);
  mcap::Message message;
  mcap::parse(record->content, message);
  given_ = true;
  return LogMessage{channels_[place.channel],
                    message.sequence,
                    LogTime(Nanoseconds(place.time_ns)),
                    static_cast<std::int64_t>(message.publish_time),
                    first.order,
                    message.data};
}

}  // namespace rocinante
