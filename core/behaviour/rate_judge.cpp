#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/behaviour/column_samples.h"
#include "core/behaviour/motion_judge.h"

namespace rocinante {
namespace {

// A rate is another one when it is beyond these times the accepted ones, and by two packets.
constexpr double kLeast = 0.67;
constexpr double kMost = 1.5;
constexpr double kSlack = 2;
constexpr std::int64_t kWindow = 1'000'000'000;
constexpr std::int64_t kSlowIntervals = 5;
constexpr std::int64_t kSilenceStep = 100'000'000;

// Intervals between statements are regular when their variance is at most this share of their
// mean's square. Of few ones it is less, since by chance any come regularly once.
constexpr double kRegular = 0.3;
constexpr double kIntervals = 72;
constexpr double kFewIntervals = 8;

/// Packets about something before a time on the line of the accepted sessions.
class PacketCount {
 public:
  PacketCount() = default;
  PacketCount(const PacketCount&) = delete;
  PacketCount& operator=(const PacketCount&) = delete;
  virtual ~PacketCount() = default;
  virtual double before(std::int64_t time) const = 0;
  double in(std::int64_t from, std::int64_t until) const { return before(until) - before(from); }
  /// About a stretch of time packets come so steadily that their absence says something.
  virtual bool isRegular(std::int64_t /*from*/, std::int64_t /*until*/) const { return true; }
  /// Between its packets; 0: unknown.
  virtual std::int64_t interval() const { return 0; }
  /// Where the last packets before a time end; unknown, and so very early, of a device.
  virtual std::int64_t lastBefore(std::int64_t /*time*/) const {
    return std::numeric_limits<std::int64_t>::min();
  }
};

class DevicePackets final : public PacketCount {
 public:
  DevicePackets(const TimeMap& map, LogTime line_start, const SessionTrack& track,
                const DeviceTrack& device)
      : map_(map), line_start_(line_start), start_(track.start) {
    sums_.push_back(0);
    for (const std::uint32_t count : device.updates) sums_.push_back(sums_.back() + count);
  }

  double before(std::int64_t time) const override {
    const LogTime its = map_.inRun(line_start_ + Nanoseconds(time));
    const double place = secondsOf(its - start_) / secondsOf(kCountBin);
    if (place <= 0) return 0;
    const auto bin = static_cast<std::size_t>(place);
    if (bin + 1 >= sums_.size()) return sums_.back();
    return sums_[bin] + (place - static_cast<double>(bin)) * (sums_[bin + 1] - sums_[bin]);
  }

 private:
  const TimeMap& map_;
  LogTime line_start_, start_;
  std::vector<double> sums_;
};

/// `series` is null where a session has none.
class SignalPackets final : public PacketCount {
 public:
  SignalPackets(const TimeMap& map, LogTime line_start, const SessionTrack& track,
                const TrackSeries* series) {
    begin_ = (map.inAccepted(track.start) - line_start).count();
    end_ = (map.inAccepted(track.end) - line_start).count();
    if (series == nullptr) return;
    TrackColumn column;
    column.kind = TrackColumn::Kind::number;
    const std::vector<std::int64_t> times = alignedTimes(track, *series, map, line_start);
    const ColumnSamples counts(track, *series, column, times);
    column.offset = 1;
    const ColumnSamples squares(track, *series, column, times);
    Sum sum;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      sum.at = times[i];
      if (sums_.empty() || sum.at > sums_.back().at) sums_.push_back(sum);
      sum.count += counts.value(i)[0];
      sum.squares += squares.value(i)[0];
      sum.at = times[i] + kSaidBin.count();
      sums_.push_back(sum);
    }
  }

  double before(std::int64_t time) const override { return sumAt(time).count; }

  bool isRegular(std::int64_t from, std::int64_t until) const override {
    const Sum first = sumAt(std::max(from, begin_));
    const Sum last = sumAt(std::min(until, end_));
    const double count = last.count - first.count;
    const double seconds = static_cast<double>(last.at - first.at) * 1e-9;
    if (count < kFewIntervals || seconds <= 0) return false;
    const double variance = (last.squares - first.squares) * count / (seconds * seconds) - 1;
    return variance <= kRegular * std::min(1.0, count / kIntervals);
  }

  std::int64_t interval() const override {
    if (sums_.empty() || sums_.back().count < kFewIntervals) return 0;
    const auto span = static_cast<double>(sums_.back().at - sums_.front().at);
    return static_cast<std::int64_t>(span / sums_.back().count);
  }

  std::int64_t lastBefore(std::int64_t time) const override {
    auto after = std::ranges::upper_bound(sums_, time, {}, &Sum::at);
    while (after != sums_.begin() && std::prev(after) != sums_.begin() &&
           std::prev(after)->count == std::prev(after, 2)->count) {
      --after;
    }
    return after == sums_.begin() ? begin_ : std::prev(after)->at;
  }

 private:
  struct Sum {
    std::int64_t at = 0;
    double count = 0, squares = 0;  ///< before `at`
  };

  Sum sumAt(std::int64_t time) const {
    const auto after = std::ranges::upper_bound(sums_, time, {}, &Sum::at);
    if (after == sums_.begin()) return {time};
    Sum sum = *std::prev(after);
    if (after != sums_.end()) {
      const double part =
          static_cast<double>(time - sum.at) / static_cast<double>(after->at - sum.at);
      sum.count += part * (after->count - sum.count);
      sum.squares += part * (after->squares - sum.squares);
    }
    sum.at = time;
    return sum;
  }

  std::int64_t begin_ = 0, end_ = 0;
  std::vector<Sum> sums_;
};

class RateJudge {
 public:
  /// `counts`: by session, the run last.
  RateJudge(const RunTimes& times, const std::string& item,
            std::vector<std::unique_ptr<PacketCount>> counts, std::int64_t bin, std::int64_t until)
      : times_(times), item_(item), counts_(std::move(counts)), bin_(bin), until_(until) {
    // Of what is seldom stated a few are missed only in a longer time.
    std::int64_t interval = 0;
    for (const auto& count : counts_) {
      const std::int64_t its = count->interval();
      if (its > 0) interval = interval == 0 ? its : std::min(interval, its);
    }
    window_ = std::max(kWindow, kSlowIntervals * interval);
    about_ = std::max(2 * window_, static_cast<std::int64_t>(kIntervals / 2) * interval);
  }

  void judge(std::vector<RunFinding>& findings) {
    // Before the log begins nothing is known.
    const std::int64_t from = std::max<std::int64_t>(0, times_.runBegin());
    for (std::int64_t at = from; at + window_ < until_; at += window_) {
      judgeStretch(at, at + window_, 2);
    }
    if (!first_) {
      in_a_row_ = 0;
      judgeStretch(from, until_, 1);
    }
    if (!first_) judgeSilence(from);
    if (first_) findings.push_back(finding());
  }

 private:
  /// A second without a packet where all accepted sessions have some, wherever it begins.
  void judgeSilence(std::int64_t from) {
    const std::int64_t reach = times_.reachOf(times_.spec.limitsOf(item_)) + bin_;
    for (std::int64_t at = from; at + window_ <= until_; at += kSilenceStep) {
      if (countIn(times_.accepted.size(), at - reach, at + window_ + reach) > 0) continue;
      judgeStretch(at, at + window_, 1);
    }
  }

  double countIn(std::size_t session, std::int64_t from, std::int64_t until) const {
    return counts_[session]->in(from, until);
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
    const bool is_less = count < kLeast * least - kSlack;
    const bool is_beyond = (is_less || count > kMost * most + kSlack) &&
                           isRegular(is_less, from - about_, until + about_);
    in_a_row_ = is_beyond ? in_a_row_ + 1 : 0;
    if (!is_beyond || times_.spec.isMasked(item_, times_.sinceOrigin(from))) return;
    if (in_a_row_ < needed) return;
    const auto before = static_cast<std::int64_t>(needed - 1);
    if (!first_) first_ = beginning(std::max<std::int64_t>(0, from - before * window_));
    last_ = until;
    spans_.push_back({times_.sinceOrigin(std::max<std::int64_t>(0, from - before * window_)),
                      times_.sinceOrigin(until)});
    const double ratio = count < least ? count / least : most / std::max(count, 1.0);
    if (worst_ && ratio >= worst_ratio_) return;
    worst_ = from;
    worst_ratio_ = ratio;
    const double seconds = static_cast<double>(until - from) * 1e-9;
    figures_ = {count / seconds, least / seconds, most / seconds};
  }

  /// Of those that have more packets.
  bool isRegular(bool is_accepted, std::int64_t from, std::int64_t until) const {
    if (!is_accepted) return counts_.back()->isRegular(from, until);
    return std::all_of(counts_.begin(), counts_.end() - 1,
                       [&](const auto& count) { return count->isRegular(from, until); });
  }

  /// Within the stretch from `time` on: where the silence begins, if it is one.
  std::int64_t beginning(std::int64_t time) const {
    const std::int64_t last = counts_.back()->lastBefore(time + window_ + bin_);
    return last > time && countIn(times_.accepted.size(), last, last + window_) == 0 ? last : time;
  }

  RunFinding finding() const {
    const auto& [rate, least, most] = figures_;
    RunFinding finding;
    finding.kind = RunFinding::Kind::rate;
    finding.item = item_;
    finding.unit = "/s";
    finding.largest = rate < least ? least - rate : rate - most;
    finding.first_accepted = times_.sinceOrigin(*first_);
    finding.first_run = times_.sinceRunOrigin(*first_);
    finding.at_accepted = times_.sinceOrigin(*worst_);
    finding.at_run = times_.sinceRunOrigin(*worst_);
    finding.until_accepted = times_.sinceOrigin(last_);
    finding.spans = joined(spans_, Nanoseconds(0));
    finding.what = fmt::format("{}: stated {:.1f} times a second, accepted {:.1f}, since {}", item_,
                               rate, rate < least ? least : most, times_.bothTimes(*first_));
    return finding;
  }

  const RunTimes& times_;
  const std::string& item_;
  std::vector<std::unique_ptr<PacketCount>> counts_;
  std::int64_t bin_, until_;
  std::int64_t window_ = kWindow, about_ = 0;  ///< before and after which it must be regular
  std::optional<std::int64_t> first_, worst_;
  std::size_t in_a_row_ = 0;
  std::int64_t last_ = 0;
  std::vector<RunSpan> spans_;
  double worst_ratio_ = 1;
  std::array<double, 3> figures_{};
};

/// The accepted sessions, then the run, each with its map.
template <class Visit>
void eachMapped(const RunTimes& times, Visit visit) {
  for (std::size_t k = 0; k < times.accepted.size(); ++k) {
    visit(*times.accepted[k], times.accepted_maps[k]);
  }
  visit(times.run, times.run_map);
}

bool hasSignal(const SessionTrack& track, const std::string& item) {
  return track.numbers.contains(item) || track.facts.contains(item);
}

/// Where both are so is what the device's finding tells.
bool tellsOf(const RunFinding& device, const RunFinding& signal) {
  const Nanoseconds slack(kWindow);
  return device.kind == RunFinding::Kind::rate && device.item == deviceOfItem(signal.item) &&
         device.first_accepted - slack <= signal.first_accepted &&
         device.until_accepted + slack >= signal.until_accepted;
}

}  // namespace

void judgeRate(const RunTimes& times, const std::string& device,
               std::vector<RunFinding>& findings) {
  std::vector<std::unique_ptr<PacketCount>> counts;
  bool is_in_all = true;
  eachMapped(times, [&](const SessionTrack& track, const TimeMap& map) {
    const auto found = track.devices.find(device);
    is_in_all = is_in_all && found != track.devices.end();
    if (!is_in_all) return;
    counts.push_back(
        std::make_unique<DevicePackets>(map, times.first().start, track, found->second));
  });
  if (!is_in_all) return;
  RateJudge(times, device, std::move(counts), kCountBin.count(), times.end()).judge(findings);
}

void judgeSignalRates(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged) {
  std::set<std::string> items;
  times.eachSession([&](const SessionTrack& track) {
    for (const auto& [item, series] : track.rhythms) items.insert(item);
  });
  std::erase_if(items, [&](const std::string& item) {
    bool is_in_all = true;
    times.eachSession(
        [&](const SessionTrack& track) { is_in_all = is_in_all && hasSignal(track, item); });
    return !is_in_all || times.spec.isMaskedThroughout(item);
  });
  const std::vector<std::string> names(items.begin(), items.end());
  std::vector<std::vector<RunFinding>> found(names.size());
  // What a log that ends early does not state any more its end tells.
  const std::int64_t until = std::min(times.end(), times.runEnd());
  forEachIndex(parallel, names.size(), [&](std::size_t i) {
    std::vector<std::unique_ptr<PacketCount>> counts;
    eachMapped(times, [&](const SessionTrack& track, const TimeMap& map) {
      const auto rhythm = track.rhythms.find(names[i]);
      counts.push_back(std::make_unique<SignalPackets>(
          map, times.first().start, track,
          rhythm == track.rhythms.end() ? nullptr : &rhythm->second));
    });
    RateJudge(times, names[i], std::move(counts), kSaidBin.count(), until).judge(found[i]);
  });
  const std::vector<RunFinding> of_devices = judged.findings;
  for (std::vector<RunFinding>& its : found) {
    for (RunFinding& finding : its) {
      const bool is_told = std::ranges::any_of(
          of_devices, [&](const RunFinding& device) { return tellsOf(device, finding); });
      if (!is_told) judged.findings.push_back(std::move(finding));
    }
  }
}

}  // namespace rocinante
