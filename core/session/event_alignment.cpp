#include "core/session/event_alignment.h"

#include <algorithm>
#include <cstdint>

namespace rocinante {
namespace {

__extension__ using Wide = __int128;

/// Size limit of the longest-common-subsequence table.
constexpr std::size_t kMaxPairs = 16'000'000;

std::vector<Event> withoutMarks(std::vector<Event> events) {
  std::erase_if(events, [](const Event& event) { return event.source.empty(); });
  return events;
}

bool isSame(const Event& a, const Event& b) { return a.text == b.text && a.source == b.source; }

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The longest common subsequence of events.
Pairs longestCommon(const std::vector<Event>& a, const std::vector<Event>& b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::uint32_t> length((a.size() + 1) * columns);
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      length[i * columns + j] =
          isSame(a[i], b[j]) ? length[(i + 1) * columns + j + 1] + 1
                             : std::max(length[(i + 1) * columns + j], length[i * columns + j + 1]);
    }
  }
  Pairs pairs;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (isSame(a[i], b[j])) {
      pairs.emplace_back(i++, j++);
    } else if (length[(i + 1) * columns + j] >= length[i * columns + j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
  return pairs;
}

/// For very many events: matches the next equal event of the other side within a window.
Pairs nearestCommon(const std::vector<Event>& a, const std::vector<Event>& b) {
  constexpr std::size_t kLookAhead = 64;
  Pairs pairs;
  std::size_t next = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = next; j < std::min(b.size(), next + kLookAhead); ++j) {
      if (!isSame(a[i], b[j])) continue;
      pairs.emplace_back(i, j);
      next = j + 1;
      break;
    }
  }
  return pairs;
}

}  // namespace

LogTime EventAlignment::inB(LogTime in_a) const {
  if (matched.empty()) return anchor_b + (in_a - anchor_a);
  if (in_a <= matched.front().a) return matched.front().b + (in_a - matched.front().a);
  const auto after = std::ranges::upper_bound(matched, in_a, {}, &MatchedEvent::a);
  const MatchedEvent& before = *std::prev(after);
  if (after == matched.end()) return before.b + (in_a - before.a);
  // Hours in nanoseconds, squared, exceed 64 bits.
  const auto product = Wide{(in_a - before.a).count()} * (after->b - before.b).count();
  return before.b + Nanoseconds(static_cast<std::int64_t>(product / (after->a - before.a).count()));
}

EventAlignment alignEvents(const std::vector<Event>& a, const std::vector<Event>& b,
                           LogTime anchor_a, LogTime anchor_b) {
  const std::vector<Event> events_a = withoutMarks(a);
  const std::vector<Event> events_b = withoutMarks(b);
  const bool is_small = (events_a.size() + 1) <= kMaxPairs / (events_b.size() + 1);
  const Pairs pairs =
      is_small ? longestCommon(events_a, events_b) : nearestCommon(events_a, events_b);
  EventAlignment alignment;
  alignment.anchor_a = anchor_a;
  alignment.anchor_b = anchor_b;
  std::vector<bool> has_a(events_a.size());
  std::vector<bool> has_b(events_b.size());
  for (const auto& [i, j] : pairs) {
    has_a[i] = has_b[j] = true;
    alignment.matched.push_back({events_a[i].text, events_a[i].time, events_b[j].time});
  }
  for (std::size_t i = 0; i < events_a.size(); ++i) {
    if (!has_a[i]) alignment.only_a.push_back(events_a[i]);
  }
  for (std::size_t j = 0; j < events_b.size(); ++j) {
    if (!has_b[j]) alignment.only_b.push_back(events_b[j]);
  }
  return alignment;
}

}  // namespace rocinante
