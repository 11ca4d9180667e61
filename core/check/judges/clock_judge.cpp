#include "core/check/judges/clock_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// A TIME before the year 2000 belongs to a simulation, not to a clock.
constexpr std::int64_t kFirstWallTime_ns = std::int64_t{946'684'800} * 1'000'000'000;
/// How much of a clock must have been seen before a step is reported: the first packets of a
/// session may all be late.
constexpr std::uint64_t kKnownPackets = 20;
constexpr Nanoseconds kKnownSpan = std::chrono::seconds(2);
/// A drift is reported when it has reached this much, over this long.
constexpr double kLeastDrift_s = 0.02;
constexpr double kLeastSpan_s = 10;
constexpr std::size_t kLeastBins = 8;

/// Saturating: a hostile TIME may be 292 years off.
std::int64_t difference(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  if (!__builtin_sub_overflow(a, b, &result)) return result;
  return a > b ? std::numeric_limits<std::int64_t>::max()
               : std::numeric_limits<std::int64_t>::min();
}

double secondsOf(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

std::string amount(double seconds) {
  if (std::abs(seconds) >= 7200) return fmt::format("{:.1f} hours", seconds / 3600);
  return fmt::format("{:.3g} s", seconds);
}

}  // namespace

void ClockJudge::take(const PacketPlace& place) {
  if (is_ignored_ || !place.sent_ns) return;
  const std::int64_t sent = *place.sent_ns;
  const std::int64_t delay = difference(place.time.time_since_epoch().count(), sent);
  if (!is_begun_ || stretch_ != place.stretch) {
    begin(place, delay);
  } else if (steps(place, delay)) {
    steps_.hit(place);
    begin(place, delay);
  } else {
    noteDelay(place, delay);
  }
  last_sent_ns_ = sent;
}

void ClockJudge::begin(const PacketPlace& place, std::int64_t delay_ns) {
  if (!is_begun_) {
    is_wall_ = *place.sent_ns >= kFirstWallTime_ns;
    first_place_ = place;
    first_place_.datagram = {};
    first_example_ = plainLine(place.datagram, 1);
  } else if (!first_least_ns_) {
    first_least_ns_ = least_ns_;
  }
  is_begun_ = true;
  stretch_ = place.stretch;
  began_ = place.time;
  count_ = 0;
  least_ns_ = delay_ns;
  least_at_ = place.time;
  bins_ = {};
  bin_ns_ = std::int64_t{1} << 27;
  noteDelay(place, delay_ns);
}

bool ClockJudge::steps(const PacketPlace& place, std::int64_t delay_ns) {
  const double back = secondsOf(difference(last_sent_ns_, *place.sent_ns));
  if (back > thresholds_.step_s) {
    worst_step_s_ = std::abs(worst_step_s_) < back ? -back : worst_step_s_;
    return true;
  }
  // A simulation may run at any speed.
  if (!is_wall_ || count_ < kKnownPackets || place.time - began_ < kKnownSpan) return false;
  const double ahead = secondsOf(difference(least_ns_, delay_ns));
  const double drifted = secondsOf((place.time - least_at_).count()) * thresholds_.drift_ppm * 1e-6;
  // A fast clock gains a fraction of each period; a clock that is set jumps at once.
  const double period = secondsOf((place.time - last_).count());
  if (ahead <= thresholds_.step_s + drifted + period) return false;
  worst_step_s_ = std::abs(worst_step_s_) < ahead ? ahead : worst_step_s_;
  return true;
}

void ClockJudge::noteDelay(const PacketPlace& place, std::int64_t delay_ns) {
  ++count_;
  last_ = place.time;
  if (delay_ns < least_ns_) {
    least_ns_ = delay_ns;
    least_at_ = place.time;
  }
  const std::int64_t at = (place.time - began_).count();
  if (at < 0) return;
  while (at / bin_ns_ >= static_cast<std::int64_t>(kBins)) {
    for (std::size_t i = 0; i < kBins / 2; ++i) {
      const Least& a = bins_[2 * i];
      const Least& b = bins_[2 * i + 1];
      bins_[i] = !b.is_set || (a.is_set && a.delay_ns <= b.delay_ns) ? a : b;
    }
    std::fill(bins_.begin() + kBins / 2, bins_.end(), Least{});
    bin_ns_ *= 2;
  }
  Least& least = bins_[static_cast<std::size_t>(at / bin_ns_)];
  if (!least.is_set || delay_ns < least.delay_ns) least = {at, delay_ns, true};
}

void ClockJudge::dropFindings() {
  steps_ = {};
  worst_step_s_ = 0;
  first_least_ns_.reset();
  const std::int64_t old_ns = (last_ - began_ - kKeptSpan).count();
  if (old_ns < bin_ns_) return;
  const std::size_t old = std::min(static_cast<std::size_t>(old_ns / bin_ns_), kBins);
  const std::int64_t moved_ns = static_cast<std::int64_t>(old) * bin_ns_;
  std::shift_left(bins_.begin(), bins_.end(), static_cast<std::ptrdiff_t>(old));
  std::fill(bins_.end() - static_cast<std::ptrdiff_t>(old), bins_.end(), Least{});
  began_ += Nanoseconds(moved_ns);
  bool has_least = false;
  for (Least& each : bins_) {
    if (!each.is_set) continue;
    each.at_ns -= moved_ns;
    if (has_least && each.delay_ns >= least_ns_) continue;
    has_least = true;
    least_ns_ = each.delay_ns;
    least_at_ = began_ + Nanoseconds(each.at_ns);
  }
}

void ClockJudge::report(const std::string& source, Findings& findings) const {
  if (is_ignored_ || !is_begun_) return;
  if (steps_.count > 0) {
    findings.push_back(
        steps_.finding("source.clock-step", source,
                       fmt::format("the clock of source {} {} by {} between two packets", source,
                                   worst_step_s_ < 0 ? "goes back" : "leaps ahead",
                                   amount(std::abs(worst_step_s_)))));
  }
  if (!is_wall_) return;
  const double skew = secondsOf(first_least_ns_.value_or(least_ns_));
  if (std::abs(skew) > thresholds_.skew_s) {
    Tally tally;
    tally.hit(first_place_);
    tally.last = last_;
    tally.example = first_example_;
    findings.push_back(
        tally.finding("source.clock-skew", source,
                      fmt::format("the clock of source {} is {} {} the recorder's", source,
                                  amount(std::abs(skew)), skew > 0 ? "behind" : "ahead of")));
    findings.back().hint = "synchronise the clocks, or send no TIME";
  }
  if (steps_.count == 0) reportDrift(source, findings);
}

// The median of the slopes between all pairs (Theil and Sen): a few delayed intervals do not change
// it.
void ClockJudge::reportDrift(const std::string& source, Findings& findings) const {
  std::vector<Least> points;
  for (const Least& least : bins_) {
    if (least.is_set) points.push_back(least);
  }
  if (points.size() < kLeastBins) return;
  const double span = secondsOf(points.back().at_ns - points.front().at_ns);
  if (span < kLeastSpan_s) return;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double moved =
          static_cast<double>(points[j].delay_ns) - static_cast<double>(points[i].delay_ns);
      slopes.push_back(moved / static_cast<double>(points[j].at_ns - points[i].at_ns));
    }
  }
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  // Delays that grow: the clock falls behind.
  const double ppm = -*middle * 1e6;
  if (std::abs(ppm) <= thresholds_.drift_ppm || std::abs(*middle) * span < kLeastDrift_s) return;
  Tally tally;
  tally.hit(first_place_);
  tally.last = last_;
  findings.push_back(
      tally.finding("source.clock-drift", source,
                    fmt::format("the clock of source {} runs {:.0f} ppm {}: {} over {:.3g} s",
                                source, std::abs(ppm), ppm > 0 ? "fast" : "slow",
                                amount(std::abs(*middle) * span), span)));
}

}  // namespace rocinante
