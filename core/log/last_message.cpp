#include "core/log/last_message.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rocinante {

LastMessage::LastMessage(SpanCache& cache) : cache_(cache), by_end_(cache.spans().size()) {
  const std::vector<MessageSpan>& spans = cache_.spans();
  std::iota(by_end_.begin(), by_end_.end(), 0U);
  std::ranges::stable_sort(by_end_, {}, [&](std::uint32_t i) { return spans[i].end_time; });
  earliest_start_.resize(by_end_.size());
  LogTime earliest = LogTime::max();
  for (std::size_t i = by_end_.size(); i-- > 0;) {
    earliest = std::min(earliest, spans[by_end_[i]].start_time);
    earliest_start_[i] = earliest;
  }
}

bool LastMessage::Found::operator<(const Found& other) const {
  if (place.time_ns != other.place.time_ns) return place.time_ns < other.place.time_ns;
  return placeInFile(span, place.offset) < placeInFile(other.span, other.place.offset);
}

std::optional<LogMessage> LastMessage::find(ChannelId channel, LogTime moment) {
  while (true) {
    const std::optional<Found> found = latest(channel, moment);
    if (!found) return std::nullopt;
    const std::optional<Found> read =
        found->by_index ? readIn(found->span, channel, moment) : found;
    const bool agrees = read && read->place.time_ns == found->place.time_ns &&
                        read->place.offset == found->place.offset;
    if (agrees) {
      held_ = cache_.get(found->span);
      return messageAt(*held_, found->place, found->span, cache_.channels());
    }
    // The cache reports a span that does not expand.
    if (misindexed_.insert(found->span).second && !cache_.get(found->span)->places.empty()) {
      const MessageSpan& span = cache_.spans()[found->span];
      cache_.addDamage(
          {span.end, span.index_end,
           "a message index disagrees with its chunk; the messages in the chunk are used",
           std::uint64_t{0}});
    }
  }
}

std::optional<LastMessage::Found> LastMessage::latest(ChannelId channel, LogTime moment) {
  const std::vector<MessageSpan>& spans = cache_.spans();
  // From here on every span begins after the moment.
  const auto behind = std::ranges::upper_bound(earliest_start_, moment);
  std::optional<Found> best;
  for (auto i = static_cast<std::size_t>(behind - earliest_start_.begin()); i-- > 0;) {
    const MessageSpan& span = spans[by_end_[i]];
    if (best && span.end_time < LogTime(Nanoseconds(best->place.time_ns))) break;
    if (span.start_time > moment || !span.mayHold(channel)) continue;
    const std::optional<Found> found = latestIn(by_end_[i], channel, moment);
    if (found && (!best || *best < *found)) best = found;
  }
  return best;
}

/// Uses the span's message index if it can be trusted.
std::optional<LastMessage::Found> LastMessage::latestIn(std::uint32_t span, ChannelId channel,
                                                        LogTime moment) {
  if (misindexed_.contains(span)) return readIn(span, channel, moment);
  const std::optional<mcap::IndexEntries> index =
      cache_.decoder().indexOf(cache_.spans()[span], channel);
  if (!index || index->size() == 0) return readIn(span, channel, moment);
  const auto until =
      static_cast<std::uint64_t>(std::max<std::int64_t>(moment.time_since_epoch().count(), -1));
  std::optional<Found> best;
  for (std::size_t i = 0; i < index->size(); ++i) {
    const std::uint64_t time = index->time(i);
    const std::uint64_t offset = index->offset(i);
    if (moment < LogTime{} || time > until || offset > std::numeric_limits<std::uint32_t>::max()) {
      continue;
    }
    const Found found{
        span, {static_cast<std::int64_t>(time), static_cast<std::uint32_t>(offset), channel}, true};
    if (!best || *best < found) best = found;
  }
  return best;
}

std::optional<LastMessage::Found> LastMessage::readIn(std::uint32_t span, ChannelId channel,
                                                      LogTime moment) {
  const std::shared_ptr<const SpanMessages> messages = cache_.get(span);
  const std::vector<SpanMessages::Place>& places = messages->places;
  const auto behind = std::ranges::upper_bound(places, moment.time_since_epoch().count(), {},
                                               &SpanMessages::Place::time_ns);
  for (auto place = behind; place != places.begin();) {
    if ((--place)->channel == channel) return Found{span, *place, false};
  }
  return std::nullopt;
}

}  // namespace rocinante
