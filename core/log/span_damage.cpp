#include "core/log/span_damage.h"

#include <algorithm>

namespace rocinante {
namespace {

/// The upper half of LogMessage::file_offset.
constexpr unsigned kSpanShift = 32;

LogPosition beginOf(std::size_t span, LogTime time) {
  return {time, std::uint64_t{span} << kSpanShift};
}

LogPosition endOf(std::size_t span, LogTime time) {
  return {time, (std::uint64_t{span} << kSpanShift) | std::numeric_limits<std::uint32_t>::max()};
}

/// The range between the first `before` spans and those from `behind` on.
UnreadableRange between(std::size_t before, std::size_t behind,
                        const std::vector<MessageSpan>& spans) {
  UnreadableRange range;
  for (std::size_t i = before; i-- > 0;) {
    if (!spans[i].hasMessages()) continue;
    range.first = endOf(i, spans[i].end_time);
    break;
  }
  for (std::size_t i = behind; i < spans.size(); ++i) {
    if (!spans[i].hasMessages()) continue;
    range.last = beginOf(i, spans[i].start_time);
    break;
  }
  return range;
}

}  // namespace

bool areInOrder(const std::vector<MessageSpan>& spans) {
  LogTime latest = LogTime::min();
  for (const MessageSpan& span : spans) {
    if (!span.hasMessages()) continue;
    if (span.start_time < latest) return false;
    latest = span.end_time;
  }
  return true;
}

std::optional<UnreadableRange> unreadableRange(const DamageSpan& damage,
                                               const std::vector<MessageSpan>& spans, bool in_order,
                                               std::uint64_t file_bytes) {
  if (damage.messages_lost == std::uint64_t{0} && !damage.out_of_order) return std::nullopt;
  if (damage.to == file_bytes && !damage.messages_lost) {
    UnreadableRange range;
    for (const MessageSpan& span : spans) {
      if (span.hasMessages()) range.first.time = std::max(range.first.time, span.end_time);
    }
    if (range.first.time != LogTime::min() && range.first.time != LogTime::max()) {
      range.first.time += Nanoseconds(1);
    }
    return range;
  }
  const auto behind = std::ranges::upper_bound(spans, damage.from, {}, &MessageSpan::offset);
  const auto next = static_cast<std::size_t>(behind - spans.begin());
  if (next > 0) {
    const MessageSpan& own = spans[next - 1];
    // For a cut one, everything before the cut is read.
    if (damage.from < std::max(own.end, own.index_end) && !own.cut) {
      UnreadableRange range;
      range.first = beginOf(next - 1, own.start_time);
      range.last = endOf(next - 1, own.end_time);
      return range;
    }
  }
  if (!in_order) return UnreadableRange{};
  const auto last = std::ranges::lower_bound(spans, damage.to, {}, &MessageSpan::offset);
  return between(next, std::max(next, static_cast<std::size_t>(last - spans.begin())), spans);
}

}  // namespace rocinante
