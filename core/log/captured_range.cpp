#include "core/log/captured_range.h"

#include <algorithm>
#include <functional>

namespace rocinante {
namespace {

bool isCapturedIn(const SpanCache& cache, ChannelId id) {
  return id < cache.channels().size() && cache.channels()[id] != nullptr &&
         cache.channels()[id]->captured();
}

/// The times of all messages, by the spans' own.
CapturedRange rangeOfSpans(const SpanCache& cache) {
  CapturedRange range;
  bool first = true;
  for (const MessageSpan& span : cache.spans()) {
    if (!span.hasMessages()) continue;
    range.start = first ? span.start_time : std::min(range.start, span.start_time);
    range.end = first ? span.end_time : std::max(range.end, span.end_time);
    first = false;
  }
  return range;
}

/// The spans that may hold captured messages.
std::vector<std::uint32_t> spansWithCaptured(const SpanCache& cache) {
  std::vector<std::uint32_t> spans;
  for (std::uint32_t i = 0; i < cache.spans().size(); ++i) {
    const std::vector<ChannelId>& ids = cache.spans()[i].channels;
    if (ids.empty() ||
        std::ranges::any_of(ids, [&](ChannelId id) { return isCapturedIn(cache, id); })) {
      spans.push_back(i);
    }
  }
  return spans;
}

LogTime earliestCaptured(SpanCache& cache, std::vector<std::uint32_t>& spans) {
  std::ranges::sort(spans, {}, [&](std::uint32_t i) { return cache.spans()[i].start_time; });
  LogTime start = LogTime::max();
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
  return start;
}

LogTime latestCaptured(SpanCache& cache, std::vector<std::uint32_t>& spans) {
  std::ranges::sort(spans, std::greater{},
                    [&](std::uint32_t i) { return cache.spans()[i].end_time; });
  LogTime end{};
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
  return end;
}

}  // namespace

CapturedRange capturedRange(SpanCache& cache, bool others) {
  if (!others) return rangeOfSpans(cache);
  std::vector<std::uint32_t> spans = spansWithCaptured(cache);
  const CapturedRange range{earliestCaptured(cache, spans), latestCaptured(cache, spans)};
  return range.start > range.end ? CapturedRange{} : range;
}

}  // namespace rocinante
