#include "core/log/captured_range.h"

#include <algorithm>
#include <functional>

namespace rocinante {
namespace {

bool isCapturedIn(const SpanCache& cache, ChannelId id) {
  return id < cache.channels().size() && cache.channels()[id] != nullptr &&
         cache.channels()[id]->captured();
}

bool mayHoldCaptured(const SpanCache& cache, const MessageSpan& span) {
  return span.channels.empty() ||
         std::ranges::any_of(span.channels, [&](ChannelId id) { return isCapturedIn(cache, id); });
}

void findEarlier(LogTime& start, SpanCache& cache, std::vector<std::uint32_t>& spans) {
  std::ranges::sort(spans, {}, [&](std::uint32_t i) { return cache.spans()[i].start_time; });
  for (const std::uint32_t i : spans) {
    const MessageSpan& span = cache.spans()[i];
    if (span.start_time >= start) break;
    const std::shared_ptr<const SpanMessages> messages = cache.get(i);
    for (const SpanMessages::Place& place : messages->places) {
      if (!isCapturedIn(cache, place.channel)) continue;
      start = std::min(start, LogTime(Nanoseconds(place.time_ns)));
      break;  // they are in order of time
    }
    // For one that cannot be read, the times of its index.
    if (messages->places.empty() && !messages->damage.empty()) {
      start = std::min(start, span.start_time);
    }
  }
}

void findLater(LogTime& end, SpanCache& cache, std::vector<std::uint32_t>& spans) {
  std::ranges::sort(spans, std::greater{},
                    [&](std::uint32_t i) { return cache.spans()[i].end_time; });
  for (const std::uint32_t i : spans) {
    const MessageSpan& span = cache.spans()[i];
    if (span.end_time <= end) break;
    const std::shared_ptr<const SpanMessages> messages = cache.get(i);
    const std::vector<SpanMessages::Place>& places = messages->places;
    if (places.empty() && !messages->damage.empty()) end = std::max(end, span.end_time);
    for (std::size_t at = places.size(); at-- > 0;) {
      if (!isCapturedIn(cache, places[at].channel)) continue;
      end = std::max(end, LogTime(Nanoseconds(places[at].time_ns)));
      break;
    }
  }
}

}  // namespace

void widen(CapturedRange& range, SpanCache& cache, std::size_t from, std::size_t until,
           bool others) {
  std::vector<std::uint32_t> mixed;
  for (std::size_t i = from; i < until; ++i) {
    const MessageSpan& span = cache.spans()[i];
    if (others) {
      if (mayHoldCaptured(cache, span)) mixed.push_back(static_cast<std::uint32_t>(i));
    } else if (span.hasMessages()) {
      range.start = std::min(range.start, span.start_time);
      range.end = std::max(range.end, span.end_time);
    }
  }
  findEarlier(range.start, cache, mixed);
  findLater(range.end, cache, mixed);
}

}  // namespace rocinante
