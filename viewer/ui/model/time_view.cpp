#include "viewer/ui/model/time_view.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace rocinante {

TimeView::TimeView(LogTime start, LogTime end)
    : start_(start), end_(std::max(end, start + Nanoseconds(1))), from_(start_), until_(end_) {}

void TimeView::show(LogTime from, LogTime until) {
  if (until < from) std::swap(from, until);
  const Nanoseconds all = end_ - start_;
  const Nanoseconds span = std::clamp(until - from, std::min(kShortest, all), all);
  from_ = std::clamp(from, start_, end_ - span);
  until_ = from_ + span;
}

void TimeView::showAll() {
  from_ = start_;
  until_ = end_;
}

void TimeView::zoom(double factor, LogTime fixed) {
  if (!(factor > 0)) return;
  const auto all = static_cast<double>((end_ - start_).count());
  const auto now = static_cast<double>(span().count());
  const double wanted = std::clamp(now * factor, 1.0, all);
  fixed = std::clamp(fixed, from_, until_);
  const auto before = static_cast<double>((fixed - from_).count()) * (wanted / now);
  const LogTime from = fixed - Nanoseconds(static_cast<std::int64_t>(before));
  show(from, from + Nanoseconds(static_cast<std::int64_t>(wanted)));
}

void TimeView::pan(double part) {
  const auto all = static_cast<double>((end_ - start_).count());
  const double by = std::clamp(static_cast<double>(span().count()) * part, -all, all);
  // Compared as lengths: times beyond the log may not exist.
  const auto whole = Nanoseconds(static_cast<std::int64_t>(by));
  const Nanoseconds moved = std::clamp(whole, start_ - from_, end_ - until_);
  from_ += moved;
  until_ += moved;
}

void TimeView::follow(LogTime moment) {
  if (moment >= from_ && moment <= until_) return;
  const Nanoseconds length = span();
  const LogTime from = moment > until_ ? moment : std::max(start_ + length, moment) - length;
  show(std::min(from, end_ - length), std::min(from, end_ - length) + length);
}

void TimeView::resize(LogTime start, LogTime end) {
  const bool all = showsAll();
  start_ = start;
  end_ = std::max(end, start + Nanoseconds(1));
  all ? showAll() : show(from_, until_);
}

}  // namespace rocinante
