#include "viewer/ui/study/log_scan.h"

namespace rocinante {
namespace {

/// How often its thread looks for wishes while it reads.
constexpr std::uint64_t kMessagesAtATime = 1024;

void addDamage(const LogReader& reader, std::vector<std::pair<LogTime, LogTime>>& damaged) {
  for (const UnreadableRange& range : reader.unreadable()) {
    damaged.emplace_back(range.first.time, range.last.time);
  }
}

}  // namespace

LogScan::LogScan(LogReader reader, SeriesScan::Options options, LogTime from, LogTime until,
                 bool follows)
    : reader_(std::move(reader)),
      series_(std::move(options)),
      from_(from),
      until_(until),
      follows_(follows) {}

Status LogScan::step() {
  for (std::uint64_t i = 0; i < kMessagesAtATime && !ended_; ++i) {
    const auto message = reader_.next();
    if (!message) return message.error();
    ended_ = !*message || (*message)->log_time > until_;
    if (ended_) return {};
    series_.add(**message);
    last_ = (*message)->place();
  }
  return {};
}

bool LogScan::grows() const {
  return follows_ && (reader_.growing() || NextPiece::expected(reader_));
}

Result<bool> LogScan::more() {
  if (!follows_ || !ended_) return false;
  const auto changed = reader_.refresh();
  if (!changed) return changed.error();
  if (*changed) {
    const Status there = last_ ? reader_.seekAfter(*last_) : reader_.rewind();
    if (!there) return there.error();
    ended_ = false;
    return true;
  }
  if (reader_.growing()) return false;
  auto next = next_piece_.after(reader_);
  if (!next) return next.error();
  if (!*next) return false;
  addLosses();
  addDamage(reader_, damaged_);
  reader_ = *std::move(*next);
  if (Status there = reader_.rewind(); !there) return there.error();
  last_.reset();
  losses_added_ = 0;
  next_begun_ = true;
  ended_ = false;
  return true;
}

bool LogScan::isFine(const SeriesKey& key, Nanoseconds most) const {
  const ValueBins* const values = series_.values(key);
  const StateSeries* const states = series_.states(key);
  return (values == nullptr || values->width() <= most) &&
         (states == nullptr || states->bins.width() <= most);
}

void LogScan::addLosses() {
  const std::vector<LossSpan>& losses = reader_.losses();
  for (; losses_added_ < losses.size(); ++losses_added_) series_.addLoss(losses[losses_added_]);
}

std::vector<std::pair<LogTime, LogTime>> LogScan::damaged() const {
  std::vector<std::pair<LogTime, LogTime>> all = damaged_;
  addDamage(reader_, all);
  return all;
}

}  // namespace rocinante
