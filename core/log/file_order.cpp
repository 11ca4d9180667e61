#include "core/log/file_order.h"

#include <algorithm>
#include <functional>

namespace rocinante {

void FileOrder::fileGrew(std::size_t first_changed) {
  if (span_ >= first_changed) {
    // By its place: its number may be another's now.
    const std::vector<MessageSpan>& spans = cache_.spans();
    const auto from =
        spans.begin() + static_cast<std::ptrdiff_t>(std::min(first_changed, spans.size()));
    const auto same = std::find_if(
        from, spans.end(), [&](const MessageSpan& span) { return span.offset >= span_begin_; });
    span_ = static_cast<std::uint32_t>(same - spans.begin());
    if (same == spans.end() || same->offset != span_begin_) behind_ = 0;
    messages_.reset();
  }
  earliest_known_ = std::min(earliest_known_, first_changed);
}

void FileOrder::read() {
  messages_ = cache_.get(span_);
  span_begin_ = cache_.spans()[span_].offset;
  ahead_.clear();
  for (const SpanMessages::Place& place : messages_->places) {
    if (place.offset >= behind_) ahead_.push_back(place);
  }
  std::ranges::sort(ahead_, std::greater{}, &SpanMessages::Place::offset);
}

std::optional<LogMessage> FileOrder::next() {
  while (span_ < cache_.spans().size()) {
    if (!messages_) read();
    if (!ahead_.empty()) {
      const SpanMessages::Place place = ahead_.back();
      ahead_.pop_back();
      behind_ = std::uint64_t{place.offset} + 1;
      return messageAt(*messages_, place, span_, cache_.channels());
    }
    // The last may get more.
    if (span_ + 1 == cache_.spans().size()) break;
    messages_.reset();
    behind_ = 0;
    ++span_;
  }
  return std::nullopt;
}

void FileOrder::skipAll() {
  if (cache_.spans().empty()) return;
  span_ = static_cast<std::uint32_t>(cache_.spans().size() - 1);
  behind_ = 0;
  read();
  if (ahead_.empty()) return;
  behind_ = std::uint64_t{ahead_.front().offset} + 1;
  ahead_.clear();
}

/// From the last span back, as far as the new ones change anything.
void FileOrder::findEarliest() {
  const std::vector<MessageSpan>& spans = cache_.spans();
  earliest_from_.resize(spans.size() + 1);
  earliest_from_.back() = LogTime::max();
  for (std::size_t i = spans.size(); i-- > 0;) {
    LogTime earliest = earliest_from_[i + 1];
    if (spans[i].hasMessages()) earliest = std::min(earliest, spans[i].start_time);
    if (i < earliest_known_ && earliest_from_[i] == earliest) break;
    earliest_from_[i] = earliest;
  }
  earliest_known_ = spans.size();
}

bool FileOrder::inOrderAt(LogPosition place) {
  const auto own = static_cast<std::uint32_t>(place.file_offset >> 32U);
  if (own >= cache_.spans().size()) return false;
  if (earliest_known_ != cache_.spans().size()) findEarliest();
  if (earliest_from_[own + 1] < place.time) return false;
  if (cache_.spans()[own].start_time >= place.time) return true;
  const std::shared_ptr<const SpanMessages> messages = cache_.get(own);
  // They are in order of time.
  for (const SpanMessages::Place& each : messages->places) {
    if (each.time_ns >= place.time.time_since_epoch().count()) break;
    if (each.offset > (place.file_offset & 0xFFFFFFFFU)) return false;
  }
  return true;
}

}  // namespace rocinante
