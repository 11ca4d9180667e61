#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/behaviour/motion_judge.h"

namespace rocinante {
namespace {

// A rate is another one when it is beyond these times the accepted ones, and by two packets.
constexpr double kLeast = 0.67;
constexpr double kMost = 1.5;
constexpr double kSlack = 2;
constexpr std::int64_t kWindow = 1'000'000'000;
constexpr std::int64_t kSilenceStep = 100'000'000;

/// Packets about a device before a time of its session.
class PacketCount {
 public:
  PacketCount(const SessionTrack& track, const DeviceTrack& device) : start_(track.start) {
    sums_.push_back(0);
    for (const std::uint32_t count : device.updates) sums_.push_back(sums_.back() + count);
  }

  double before(LogTime time) const {
    const double place = secondsOf(time - start_) / secondsOf(kCountBin);
    if (place <= 0) return 0;
    const auto bin = static_cast<std::size_t>(place);
    if (bin + 1 >= sums_.size()) return sums_.back();
    return sums_[bin] + (place - static_cast<double>(bin)) * (sums_[bin + 1] - sums_[bin]);
  }

 private:
  LogTime start_;
  std::vector<double> sums_;
};

class RateJudge {
 public:
  RateJudge(const RunTimes& times, const std::string& device) : times_(times), device_(device) {}

  void judge(std::vector<RunFinding>& findings) {
    for (const SessionTrack* track : times_.accepted) {
      if (!add(*track)) return;
    }
    if (!add(times_.run)) return;
    // Before the log begins nothing is known.
    const std::int64_t from = std::max<std::int64_t>(0, times_.runBegin());
    for (std::int64_t at = from; at + kWindow < times_.end(); at += kWindow) {
      judgeStretch(at, at + kWindow, 2);
    }
    if (!first_) {
      in_a_row_ = 0;
      judgeStretch(from, times_.end(), 1);
    }
    if (!first_) judgeSilence(from);
    if (first_) findings.push_back(finding());
  }

 private:
  /// A second without a packet where all accepted sessions have some, wherever it begins.
  void judgeSilence(std::int64_t from) {
    const std::int64_t reach = times_.reachOf(times_.spec.limitsOf(device_)) + kCountBin.count();
    for (std::int64_t at = from; at + kWindow <= times_.end(); at += kSilenceStep) {
      if (countIn(times_.accepted.size(), at - reach, at + kWindow + reach) > 0) continue;
      judgeStretch(at, at + kWindow, 1);
    }
  }

  bool add(const SessionTrack& track) {
    const auto found = track.devices.find(device_);
    if (found == track.devices.end()) return false;
    counts_.emplace_back(track, found->second);
    return true;
  }

  double countIn(std::size_t session, std::int64_t from, std::int64_t until) const {
    const auto before = [&](std::int64_t time) {
      const bool is_run = session == times_.accepted.size();
      return counts_[session].before(is_run ? times_.inRun(time)
                                            : times_.inAccepted(session, time));
    };
    return before(until) - before(from);
  }

  void judgeStretch(std::int64_t from, std::int64_t until, std::size_t needed) {
    if (until <= from) return;
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (std::size_t k = 0; k < times_.accepted.size(); ++k) {
      const double count = countIn(k, from, until);
      least = std::min(least, count);
      most = std::max(most, count);
    }
    const double count = countIn(times_.accepted.size(), from, until);
    const bool is_beyond = count < kLeast * least - kSlack || count > kMost * most + kSlack;
    in_a_row_ = is_beyond ? in_a_row_ + 1 : 0;
    if (!is_beyond || times_.spec.isMasked(device_, times_.sinceOrigin(from))) return;
    if (in_a_row_ < needed) return;
    const auto before = static_cast<std::int64_t>(needed - 1);
    if (!first_) first_ = std::max<std::int64_t>(0, from - before * kWindow);
    last_ = until;
    spans_.push_back({times_.sinceOrigin(std::max<std::int64_t>(0, from - before * kWindow)),
                      times_.sinceOrigin(until)});
    const double ratio = count < least ? count / least : most / std::max(count, 1.0);
    if (worst_ && ratio >= worst_ratio_) return;
    worst_ = from;
    worst_ratio_ = ratio;
    const double seconds = static_cast<double>(until - from) * 1e-9;
    figures_ = {count / seconds, least / seconds, most / seconds};
  }

  RunFinding finding() const {
    const auto& [rate, least, most] = figures_;
    RunFinding finding;
    finding.kind = RunFinding::Kind::rate;
    finding.item = device_;
    finding.unit = "/s";
    finding.largest = rate < least ? least - rate : rate - most;
    finding.first_accepted = times_.sinceOrigin(*first_);
    finding.first_run = times_.sinceRunOrigin(*first_);
    finding.at_accepted = times_.sinceOrigin(*worst_);
    finding.at_run = times_.sinceRunOrigin(*worst_);
    finding.until_accepted = times_.sinceOrigin(last_);
    finding.spans = joined(spans_, Nanoseconds(0));
    finding.what =
        fmt::format("{}: stated {:.1f} times a second, accepted {:.1f}, since {}", device_, rate,
                    rate < least ? least : most, times_.bothTimes(*first_));
    return finding;
  }

  const RunTimes& times_;
  const std::string& device_;
  std::vector<PacketCount> counts_;  ///< by session, the run last
  std::optional<std::int64_t> first_, worst_;
  std::size_t in_a_row_ = 0;
  std::int64_t last_ = 0;
  std::vector<RunSpan> spans_;
  double worst_ratio_ = 1;
  std::array<double, 3> figures_{};
};

}  // namespace

void judgeRate(const RunTimes& times, const std::string& device,
               std::vector<RunFinding>& findings) {
  RateJudge(times, device).judge(findings);
}

}  // namespace rocinante
