#include "core/log/span_merge.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rocinante {
namespace {

/// The limit for all expanded spans together; beyond it, waiting ones are released.
constexpr std::size_t kHeldBytes = std::size_t{48} << 20U;

/// If overlapping chunks alternate message by message, releasing and expanding them again would
/// take for ever: after this many repeated expansions the limit doubles, up to a maximum.
constexpr std::size_t kExpandedAgain = 8;
constexpr std::size_t kMaxHeldBytes = std::size_t{768} << 20U;

}  // namespace

LogPosition SpanMerge::behind(LogPosition place) {
  if (place.file_offset < std::numeric_limits<std::uint64_t>::max()) {
    return {place.time, place.file_offset + 1};
  }
  return place.time == LogTime::max() ? place : LogPosition{place.time + Nanoseconds(1), 0};
}

void SpanMerge::fileGrew(std::size_t first_changed) {
  seek(kBeginning);
  open_.clear();
  for (Order& order : orders_) {
    if (order.spans.size() <= first_changed) continue;
    // In the order of the file they are the last; otherwise all are sorted again.
    while (!order.spans.empty() && order.spans.back() >= first_changed) {
      order.spans.pop_back();
      order.latest_end.pop_back();
    }
    if (order.spans.size() != first_changed) order = {};
  }
}

std::int64_t SpanMerge::startOf(std::uint32_t span) const {
  const MessageSpan& each = cache_.spans()[span];
  return mirrored(nanosecondsOf(way_ == kForwards ? each.start_time : each.end_time));
}

std::int64_t SpanMerge::endOf(std::uint32_t span) const {
  const MessageSpan& each = cache_.spans()[span];
  return mirrored(nanosecondsOf(way_ == kForwards ? each.end_time : each.start_time));
}

void SpanMerge::sortNewSpans() {
  Order& order = orders_[way_];
  const std::size_t known = order.spans.size();
  if (known == cache_.spans().size()) return;
  order.spans.resize(cache_.spans().size());
  const auto added = order.spans.begin() + static_cast<std::ptrdiff_t>(known);
  std::iota(added, order.spans.end(), static_cast<std::uint32_t>(known));
  const auto begins_before = [&](std::uint32_t a, std::uint32_t b) {
    return startOf(a) < startOf(b);
  };
  if (!std::is_sorted(known == 0 ? added : added - 1, order.spans.end(), begins_before)) {
    std::stable_sort(order.spans.begin(), order.spans.end(), begins_before);
    order.latest_end.clear();
  }
  std::int64_t latest =
      order.latest_end.empty() ? std::numeric_limits<std::int64_t>::min() : order.latest_end.back();
  for (std::size_t i = order.latest_end.size(); i < order.spans.size(); ++i) {
    latest = std::max(latest, endOf(order.spans[i]));
    order.latest_end.push_back(latest);
  }
}

void SpanMerge::seek(LogPosition place) {
  place_ = place;
  begun_ = false;
}

/// Begins in a direction, or reverses, at the current position.
void SpanMerge::begin(Way way) {
  way_ = way;
  open_.clear();
  given_ = false;
  from_ = place_;
  sortNewSpans();
  // Every span before this ends before the position.
  const std::vector<std::int64_t>& ends = orders_[way_].latest_end;
  const auto first = std::ranges::lower_bound(ends, mirrored(nanosecondsOf(from_.time)));
  next_span_ = static_cast<std::size_t>(first - ends.begin());
  begun_ = true;
}

/// Reads the next message of `open`.
void SpanMerge::take(Open& open) {
  const SpanMessages::Place& place = open.messages->places[open.at];
  open.time_ns = mirrored(place.time_ns);
  open.order = mirrored(placeInFile(open.span, place.offset));
}

void SpanMerge::openNextSpan() {
  const std::uint32_t span = orders_[way_].spans[next_span_++];
  if (endOf(span) < mirrored(nanosecondsOf(from_.time))) return;
  Open open;
  open.span = span;
  open.messages = cache_.get(span);
  const std::vector<SpanMessages::Place>& places = open.messages->places;
  const auto isBefore = [&](const SpanMessages::Place& place) {
    return LogPosition{LogTime(Nanoseconds(place.time_ns)), placeInFile(span, place.offset)} <
           from_;
  };
  const auto ahead = std::ranges::partition_point(places, isBefore);
  open.at = static_cast<std::size_t>(ahead - places.begin());
  if (way_ == kBackwards) --open.at;  // past the end, if there is none
  if (open.at >= places.size()) return;
  take(open);
  open_.push_back(std::move(open));
  std::ranges::push_heap(open_, Later{});
  releaseOthers();
}

void SpanMerge::releaseOthers() {
  if (open_.size() < 2) return;
  std::size_t held = 0;
  for (const Open& open : open_) held += open.messages ? open.messages->heldBytes() : 0;
  if (held <= std::max(held_limit_, kHeldBytes)) return;
  for (std::size_t i = 1; i < open_.size(); ++i) open_[i].messages.reset();
}

/// Expands a released span again; its next message has the same index as before. False when the
/// file has changed since and the message is gone.
bool SpanMerge::reload(Open& open) {
  open.messages = cache_.get(open.span);
  held_limit_ = std::max(held_limit_, kHeldBytes);
  expanded_again_ += open.messages->heldBytes();
  if (expanded_again_ > kExpandedAgain * held_limit_ && held_limit_ < kMaxHeldBytes) {
    held_limit_ *= 2;
    expanded_again_ = 0;
  }
  releaseOthers();
  return open.at < open.messages->places.size();
}

void SpanMerge::advance() {
  given_ = false;
  Open& first = open_.front();
  first.at += way_ == kForwards ? std::size_t{1} : ~std::size_t{0};
  if (first.at < first.messages->places.size()) {
    take(first);
    if (open_.size() == 1) return;
    std::ranges::pop_heap(open_, Later{});
    std::ranges::push_heap(open_, Later{});
    return;
  }
  dropFirst();
}

void SpanMerge::dropFirst() {
  std::ranges::pop_heap(open_, Later{});
  open_.pop_back();
}

std::optional<LogMessage> SpanMerge::step(Way way) {
  if (!begun_ || way != way_) begin(way);
  if (given_) advance();
  const std::vector<std::uint32_t>& spans = orders_[way_].spans;
  while (true) {
    while (next_span_ < spans.size() &&
           (open_.empty() || startOf(spans[next_span_]) <= open_.front().time_ns)) {
      openNextSpan();
    }
    if (open_.empty()) return std::nullopt;
    if (open_.front().messages || reload(open_.front())) break;
    dropFirst();
  }
  const Open& first = open_.front();
  given_ = true;
  const LogMessage message =
      messageAt(*first.messages, first.messages->places[first.at], first.span, cache_.channels());
  place_ = way_ == kForwards ? behind(message.place()) : message.place();
  return message;
}

}  // namespace rocinante
