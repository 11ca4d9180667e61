#include "core/check/judges/cadence_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace rocinante {
namespace {

/// The rate is measured over windows at least this long, with at least this many packets.
constexpr double kWindow_s = 2;
constexpr double kWindowPackets = 20;
/// The error that a window's edges can cause in its rate.
constexpr double kRateSlack = 0.05;
/// A source sent often if its run has this many packets, with at most this mean interval.
constexpr std::uint64_t kOftenPackets = 20;
constexpr double kOften_s = 1;
/// A silence is this many periods, and at least this long.
constexpr double kSilencePeriods = 20;
constexpr double kLeastSilence_s = 0.25;
/// How much of a source shows its usual interval.
constexpr double kKnownRhythm_s = 2;
/// Restatements come every two seconds.
constexpr double kIdle_s = 3;
/// The mean period is known after this many intervals, and follows about as many.
constexpr std::uint64_t kKnownIntervals = 32;
/// An interval of this many periods is a pause, not jitter.
constexpr double kPausePeriods = 10;
/// Reported when more than this fraction of the packets is uneven.
constexpr double kUnevenPart = 0.05;
constexpr std::uint64_t kLeastUneven = 10;

}  // namespace

void UsualInterval::take(Nanoseconds interval) {
  if (interval.count() <= 0) return;
  const auto ns = static_cast<std::uint64_t>(interval.count());
  const auto octave = static_cast<unsigned>(std::bit_width(ns)) - 1;
  std::size_t bin = 0;
  if (octave >= kFirstOctave) {
    bin = 4 * std::size_t{octave - kFirstOctave} + ((ns >> (octave - 2)) & 3U);
  }
  time_ns_[std::min(bin, kBins - 1)] += interval.count();
}

double UsualInterval::span_s() const {
  return static_cast<double>(std::accumulate(time_ns_.begin(), time_ns_.end(), std::int64_t{0})) *
         1e-9;
}

double UsualInterval::seconds() const {
  const std::int64_t all = std::accumulate(time_ns_.begin(), time_ns_.end(), std::int64_t{0});
  std::int64_t below = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    below += time_ns_[bin];
    if (below == 0 || 2 * below < all) continue;
    const double middle = 1.125 + 0.25 * static_cast<double>(bin % 4);
    return std::ldexp(middle, static_cast<int>(kFirstOctave + bin / 4)) * 1e-9;
  }
  return 0;
}

void UsualInterval::fade() {
  for (std::int64_t& each : time_ns_) each /= 2;
}

void CadenceJudge::begin(const PacketPlace& place) {
  is_begun_ = true;
  stretch_ = place.stretch;
  began_ = last_ = last_sign_ = window_began_ = place.time;
  packets_ = 1;
  ++all_packets_;
  window_sent_ = 0;
  // Packets that queued before the listener started arrive at once.
  window_has_pause_ = true;
  was_long_ = false;
  intervals_ = 0;
  period_s_ = 0;
  usual_.clear();
  is_steady_ = true;
  was_restatement_ = was_pause_ = false;
}

void CadenceJudge::take(const PacketPlace& place, std::uint64_t lost) {
  last_place_ = place;
  last_place_.datagram = {};
  if (!is_begun_ || stretch_ != place.stretch) return begin(place);
  judgeSilence(place, false);
  const double interval_s = secondsOf(place.time - last_);
  const bool is_pause = interval_s > kLeastSilence_s && interval_s > silenceLimit();
  const std::uint64_t sent = std::min<std::uint64_t>(lost, 1000) + 1;
  ++packets_;
  ++all_packets_;
  if (thresholds_.rate_hz) judgeRate(place, sent, interval_s);
  if (thresholds_.jitter_s) judgeJitter(place, interval_s, sent, is_pause);
  // One pause is none of its intervals; one after the other, they are its rate.
  if (!is_pause || was_pause_) usual_.take(place.time - last_);
  was_pause_ = is_pause;
  last_ = last_sign_ = place.time;
  was_restatement_ = false;
}

void CadenceJudge::takeRestatement(const PacketPlace& place) {
  if (!is_begun_ || stretch_ != place.stretch) return begin(place);
  judgeSilence(place, true);
  is_steady_ = is_steady_ && !was_restatement_;
  last_sign_ = place.time;
  was_restatement_ = true;
}

bool CadenceJudge::isExpected() const {
  if (thresholds_.is_silence_given) return true;
  if (thresholds_.rate_hz && thresholds_.rate_hz->first > 0) return true;
  return packets_ >= kOftenPackets &&
         secondsOf(last_ - began_) < kOften_s * static_cast<double>(packets_);
}

double CadenceJudge::silenceLimit() const {
  if (thresholds_.is_silence_own) return thresholds_.silence_s;
  const bool is_rate_given = thresholds_.rate_hz && thresholds_.rate_hz->first > 0;
  if (!is_rate_given && usual_.span_s() < kKnownRhythm_s) return thresholds_.silence_s;
  const double period_s = is_rate_given ? 1 / thresholds_.rate_hz->first : usual_.seconds();
  return std::clamp(kSilencePeriods * period_s, kLeastSilence_s,
                    std::max(kLeastSilence_s, thresholds_.silence_s));
}

double CadenceJudge::idleLimit() const {
  return thresholds_.is_silence_own ? thresholds_.silence_s : std::max(kIdle_s, silenceLimit());
}

void CadenceJudge::Silences::hit(const PacketPlace& place, LogTime since, double limit) {
  PacketPlace began = place;
  began.time = since;
  tally.hit(began);
  tally.last = place.time;
  const double silent_s = secondsOf(place.time - since);
  if (silent_s <= longest_s) return;
  longest_s = silent_s;
  limit_s = limit;
}

void CadenceJudge::judgeSilence(const PacketPlace& place, bool is_restatement) {
  const double silent_s = secondsOf(place.time - last_sign_);
  if (silent_s <= std::min(kLeastSilence_s, thresholds_.silence_s) || !isExpected()) return;
  const double idle_s = idleLimit();
  if (silent_s > idle_s) idle_silences_.hit(place, last_sign_, idle_s);
  const bool may_idle = is_restatement || was_restatement_;
  const double limit_s = may_idle ? idle_s : silenceLimit();
  if (silent_s > limit_s) silences_.hit(place, last_sign_, limit_s);
}

void CadenceJudge::judgeRate(const PacketPlace& place, std::uint64_t sent, double interval_s) {
  const auto [low, high] = *thresholds_.rate_hz;
  window_sent_ += sent;
  // One long interval is a silence, and reported as that; one after the other, they are the rate.
  const bool is_long = low > 0 && interval_s > silenceLimit();
  if (is_long && !was_long_) window_has_pause_ = true;
  was_long_ = is_long;
  const double window_s = secondsOf(place.time - window_began_);
  const double wanted_s = low > 0 ? std::max(kWindow_s, kWindowPackets / low) : kWindow_s;
  if (window_s < wanted_s) return;
  const double rate_hz = static_cast<double>(window_sent_) / window_s;
  if (!window_has_pause_) {
    const double off =
        std::max(low * (1 - kRateSlack) - rate_hz, rate_hz - high * (1 + kRateSlack));
    if (off > 0) {
      rate_.hit(place);
      if (off > worst_rate_off_) {
        worst_rate_off_ = off;
        worst_rate_hz_ = rate_hz;
      }
    }
  }
  window_began_ = place.time;
  window_sent_ = 0;
  window_has_pause_ = false;
}

void CadenceJudge::judgeJitter(const PacketPlace& place, double interval_s, std::uint64_t sent,
                               bool is_pause) {
  // Where packets were lost, the interval holds several periods.
  const double per_packet_s = interval_s / static_cast<double>(sent);
  const bool is_known = intervals_ >= kKnownIntervals;
  if (is_pause || (is_known && per_packet_s > kPausePeriods * period_s_ + *thresholds_.jitter_s)) {
    return;
  }
  ++intervals_;
  const double weight =
      1 / static_cast<double>(std::min<std::uint64_t>(intervals_, 2 * kKnownIntervals));
  const double uneven_s = std::abs(per_packet_s - period_s_);
  period_s_ += (per_packet_s - period_s_) * weight;
  if (!is_known || uneven_s <= *thresholds_.jitter_s) return;
  uneven_.hit(place);
  worst_uneven_s_ = std::max(worst_uneven_s_, uneven_s);
}

void CadenceJudge::dropFindings() {
  rate_ = {};
  silences_ = idle_silences_ = {};
  usual_.fade();
  worst_rate_hz_ = worst_rate_off_ = 0;
  all_packets_ /= 2;
  uneven_.count /= 2;
  if (uneven_.count > 0) return;
  uneven_ = {};
  worst_uneven_s_ = 0;
}

void CadenceJudge::report(const std::string& source, LogTime end, Findings& findings) const {
  if (!is_begun_) return;
  Silences silences = is_steady_ ? silences_ : idle_silences_;
  const double limit_s = is_steady_ && !was_restatement_ ? silenceLimit() : idleLimit();
  if (secondsOf(end - last_sign_) > limit_s && isExpected()) {
    PacketPlace place = last_place_;
    place.line = 0;
    place.time = end;
    silences.hit(place, last_sign_, limit_s);
  }
  if (silences.tally.count > 0) {
    findings.push_back(silences.tally.finding(
        "source.silence", source,
        fmt::format("source {} was silent for {:.3g} s; {:.2g} s are expected at most", source,
                    silences.longest_s, silences.limit_s)));
  }
  if (rate_.count > 0) {
    const auto [low, high] = *thresholds_.rate_hz;
    findings.push_back(rate_.finding(
        "source.rate", source,
        fmt::format("source {} sends {:.3g} packets per second, where the cell expects {:.6g} to "
                    "{:.6g}",
                    source, worst_rate_hz_, low, high)));
  }
  const double part = static_cast<double>(uneven_.count) /
                      static_cast<double>(std::max<std::uint64_t>(all_packets_, 1));
  if (uneven_.count >= kLeastUneven && part > kUnevenPart) {
    findings.push_back(uneven_.finding(
        "source.jitter", source,
        fmt::format("{:.0f} % of the packets of source {} arrive more than {:.6g} ms off their "
                    "period; the worst by {:.3g} ms",
                    part * 100, source, *thresholds_.jitter_s * 1e3, worst_uneven_s_ * 1e3)));
  }
}

}  // namespace rocinante
