#include "core/log/span_cache.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {
namespace {

/// The memory for spans that are no longer held elsewhere.
constexpr std::size_t kKeptBytes = std::size_t{12} << 20U;
constexpr std::size_t kKeptSpans = 64;

}  // namespace

SpanCache::SpanCache(ByteView file, const MappedFile* mapped, const std::vector<MessageSpan>& spans,
                     const std::vector<const LogChannel*>& channels,
                     std::vector<DamageSpan>& damage)
    : spans_(spans),
      channels_(channels),
      damage_(damage),
      decoder_(file, mapped, &channels),
      reported_(spans.size(), false),
      faulty_(spans.size(), false) {}

void SpanCache::fileGrew(ByteView file, std::size_t first_changed) {
  decoder_.useFile(file);
  for (std::vector<bool>* const by_span : {&reported_, &faulty_}) {
    by_span->resize(std::min(first_changed, by_span->size()));
    by_span->resize(spans_.size(), false);
  }
  std::erase_if(kept_, [&](const Kept& kept) { return kept.span >= first_changed; });
}

std::shared_ptr<const SpanMessages> SpanCache::get(std::uint32_t span) {
  const auto found = std::ranges::find(kept_, span, &Kept::span);
  if (found != kept_.end()) {
    std::rotate(found, found + 1, kept_.end());
    return kept_.back().messages;
  }
  std::shared_ptr<SpanMessages> messages = makeRoom();
  if (!messages) messages = std::make_shared<SpanMessages>();
  decoder_.decode(spans_[span], *messages);
  report(span, *messages);
  kept_.push_back({span, messages});
  return messages;
}

/// Releases the least recently used spans beyond the limit; returns the last one released, if any,
/// so that its memory is reused.
std::shared_ptr<SpanMessages> SpanCache::makeRoom() {
  std::size_t held = 0;
  std::size_t spans = kept_.size();
  // A span that is held elsewhere costs nothing here.
  const auto free = [](const Kept& kept) { return kept.messages.use_count() == 1; };
  for (const Kept& kept : kept_) held += free(kept) ? kept.messages->heldBytes() : 0;
  std::shared_ptr<SpanMessages> last;
  for (auto each = kept_.begin();
       each != kept_.end() && (held > kKeptBytes || spans > kKeptSpans);) {
    if (!free(*each)) {
      ++each;
      continue;
    }
    held -= each->messages->heldBytes();
    --spans;
    last = std::move(each->messages);
    each = kept_.erase(each);
  }
  if (last && last->heldBytes() > kKeptBytes) last.reset();
  return last;
}

/// Lists the span's damage when it is first read, and removes messages on unknown channels.
void SpanCache::report(std::uint32_t span, SpanMessages& messages) {
  const MessageSpan& where = spans_[span];
  const std::size_t found = messages.places.size();
  const std::size_t orphans = std::erase_if(messages.places, [&](const SpanMessages::Place& place) {
    return place.channel >= channels_.size() || channels_[place.channel] == nullptr;
  });
  if (reported_[span]) {
    // It was read before: only the file can have changed since, or the disk failed.
    if (!messages.damage.empty() && !faulty_[span]) {
      faulty_[span] = true;
      std::ranges::copy(messages.damage, std::back_inserter(damage_));
    }
    return;
  }
  reported_[span] = true;
  faulty_[span] = !messages.damage.empty();
  std::ranges::copy(messages.damage, std::back_inserter(damage_));
  if (orphans > 0) {
    damage_.push_back({where.offset, where.end,
                       countText(orphans, "message") + " on an undefined channel",
                       std::uint64_t{orphans}});
  }
  for (const ByteView content : messages.channels) {
    mcap::Channel channel;
    if (!mcap::parse(content, channel)) continue;
    const LogChannel* const known = channel.id < channels_.size() ? channels_[channel.id] : nullptr;
    if (known == nullptr || known->topic != channel.topic ||
        known->encoding != channel.message_encoding || known->metadata != channel.metadata) {
      damage_.push_back({where.offset, where.end,
                         fmt::format("channel {} is defined again as another", channel.id),
                         std::nullopt});
    }
  }
  if (messages.places.empty()) return;
  if (where.indexed_messages && messages.damage.empty() && *where.indexed_messages != found) {
    damage_.push_back({where.offset, where.end,
                       fmt::format("the message indexes after a chunk list {}, but it holds {}",
                                   countText(*where.indexed_messages, "message"), found),
                       std::uint64_t{0}});
  }
  if (messages.places.front().time_ns < where.start_time.time_since_epoch().count() ||
      messages.places.back().time_ns > where.end_time.time_since_epoch().count()) {
    damage_.push_back({where.offset, where.end,
                       "a chunk holds messages outside the times in its index", std::uint64_t{0},
                       true});
  }
}

LogMessage messageAt(const SpanMessages& messages, const SpanMessages::Place& place,
                     std::uint32_t span, const std::vector<const LogChannel*>& channels) {
  // The position came from this very record; if the file has changed since, there is no payload.
  mcap::Message message;
  const std::optional<mcap::Record> record = mcap::recordAt(messages.records, place.offset);
  if (record) mcap::parse(record->content, message);
  return LogMessage{channels[place.channel],
                    message.sequence,
                    LogTime(Nanoseconds(place.time_ns)),
                    static_cast<std::int64_t>(message.publish_time),
                    placeInFile(span, place.offset),
                    message.data};
}

}  // namespace rocinante
