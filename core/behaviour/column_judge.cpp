#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/behaviour/column_finding.h"
#include "core/behaviour/motion_judge.h"
#include "core/behaviour/session_track.h"

namespace rocinante {
namespace {

constexpr std::int64_t kAbsent = 1'000'000'000;

class ColumnJudge {
 public:
  ColumnJudge(const RunTimes& times, std::string item, const TrackColumn& column,
              const std::vector<ColumnSamples>& accepted, const ColumnSamples& run)
      : times_(times), item_(std::move(item)), column_(column), accepted_(accepted), run_(run) {
    const RunLimits limits = times.spec.limitsOf(item_);
    reach_ = times.reachOf(limits);
    if (column.kind == TrackColumn::Kind::number) {
      measures_.push_back({column.unit,
                           "signal",
                           limits.signal.value_or(learntLimit(limits, accepted).limit),
                           0,
                           1,
                           {}});
    } else if (column.kind == TrackColumn::Kind::pose) {
      measures_.push_back({"mm", "pose_mm", limits.ofPose_mm(), 0, 3, {}});
      measures_.push_back({"°", "pose_deg", limits.ofPose_deg(), 3, 3, {}});
    } else if (column.kind == TrackColumn::Kind::link_pose) {
      if (limits.link_positions) {
        measures_.push_back({"mm", "position_mm", limits.position_mm, 0, 3, {}});
      }
      if (limits.link_turns) measures_.push_back({"°", "turn_deg", limits.turn_deg, 3, 3, {}});
    } else if (column.kind == TrackColumn::Kind::length) {
      measures_.push_back({"mm", "position_mm", limits.position_mm, 0, 1, {}});
    } else {
      measures_.push_back({"°", "joint_deg", limits.joint_deg, 0, 1, {}});
    }
    has_masks_ = !times.spec.masks.empty();
    // Nearer to an end than a value may be late or early, the motion beyond it is unknown.
    const std::int64_t end = times.end();
    from_ = end > 4 * reach_ ? reach_ : 0;
    until_ = end - from_;
  }

  void judge(std::vector<RunFinding>& findings) {
    for (std::size_t i = 0; i < run_.size(); ++i) {
      if (run_.isStated(i)) judgeOwn(run_.time(i), run_.value(i));
      if (failing_ == 0) endStretch(run_.time(i), run_, accepted_.front());
    }
    endStretch(times_.end(), run_, accepted_.front());
    judgeHeld();
    for (std::size_t session = 0; session < accepted_.size(); ++session) {
      absent_.reset();
      const ColumnSamples& its = accepted_[session];
      for (std::size_t i = 0; i < its.size(); ++i) {
        judgeAccepted(session, i);
        if (failing_ == 0) endStretch(its.time(i), its, run_);
      }
      endStretch(times_.end(), its, run_);
      if (absent_) noteAbsence(std::min(times_.end(), times_.runEnd()));
    }
    addFindings(findings);
  }

  std::uint64_t values() const { return values_; }

  FastMotion fastest() const {
    FastMotion fastest{item_, measures_.front().unit, 0, 0, 0};
    if (column_.width() != 1 || column_.kind == TrackColumn::Kind::number) return fastest;
    fastest.figure = accepted_.front().farthestWithin(reach_, fastest.at) *
                     (column_.kind == TrackColumn::Kind::length ? kMillimetres : kDegrees);
    fastest.times_limit = fastest.figure / measures_.front().limit;
    return fastest;
  }

 private:
  bool isOutside(std::int64_t time) const {
    return time < from_ || time > until_ ||
           (has_masks_ && times_.spec.isMasked(item_, times_.sinceOrigin(time)));
  }

  /// What was stated where nothing is judged, and holds from there on.
  void judgeHeld() {
    if (run_.size() == 0) return;
    std::vector<std::int64_t> moments{from_};
    for (const ColumnSamples& its : accepted_) {
      if (its.size() > 0) moments.push_back(std::max(run_.time(0), its.time(0)) + reach_);
    }
    const LogTime start = times_.first().start;
    for (const RunMask& mask : times_.spec.masks) {
      if (mask.until == Nanoseconds::max()) continue;
      moments.push_back((times_.first().origin + mask.until - start).count() + 1);
    }
    double held[7];
    for (const std::int64_t time : moments) {
      if (run_.isHeld(time) && run_.valueAt(time, held)) judgeOwn(time, held);
      endStretch(times_.end(), run_, accepted_.front());
    }
  }

  /// A value of the run, in what the accepted ones have about its time.
  void judgeOwn(std::int64_t time, const double* own) {
    if (isOutside(time)) return;
    ++values_;
    apparent_ = 0;
    for (const ColumnSamples& its : accepted_) {
      if (!isNear(its, time, own)) continue;
      failing_ = 0;
      return;
    }
    if (!isWeighed(time)) return;
    ApartRange band;
    for (const ColumnSamples& its : accepted_) {
      // What came before its first packet is unknown.
      if (its.size() == 0 || time < its.time(0) + reach_) continue;
      add(band, its.wideRange(time - reach_, time + reach_, own));
    }
    if (band.any) note(band, time, Apart{});
  }

  /// A value that an accepted session has, in what the run has about its time.
  void judgeAccepted(std::size_t session, std::size_t i) {
    const ColumnSamples& its = accepted_[session];
    const std::int64_t time = its.time(i);
    if (isOutside(time)) return;
    if (!its.isStated(i)) {
      absent_.reset();
      return;
    }
    ++values_;
    const double* const value = its.value(i);
    apparent_ = 0;
    if (isNear(run_, time, value)) {
      absent_.reset();
      failing_ = 0;
      return;
    }
    if (!isWeighed(time)) return;
    const ApartRange around = run_.size() > 0 && time < run_.time(0)
                                  ? ApartRange{}
                                  : run_.wideRange(time - reach_, time + reach_, value);
    if (!around.any) {
      judgeAbsence(session, time);
      return;
    }
    absent_.reset();
    const bool is_at_edge = time < run_.time(0) + reach_ || isAtEndOfBoth(time);
    if (is_at_edge || largestBeyond(around) <= 0 || !isCommon(session, time, value)) {
      failing_ = 0;
      return;
    }
    const ApartRange nearest = fromAll(session, around, time, value);
    const Apart lost = lostAt(its, time, value);
    // As near as the nearest session is, the value of this one is missing all the same.
    if (largestBeyond(nearest) > 0) {
      note(nearest, time, lost);
    } else {
      noteMissing(around, time, lost);
    }
  }

  /// False for some packets in a long stretch that is not as accepted, where it has begun, how far
  /// it goes and how it ends are what counts. Many windows of many packets would take minutes.
  bool isWeighed(std::int64_t time) {
    constexpr std::size_t kStretch = 64;
    const bool is_long = column_.width() == 1 && failing_ > kStretch;
    const bool is_soon = std::abs(time - weighed_) < reach_ / 2;
    if (is_long && is_soon && apparent_ <= 2 * measures_.front().largest) return false;
    weighed_ = time;
    return true;
  }

  /// True when a packet within `event_ms` is near enough: most are.
  bool isNear(const ColumnSamples& samples, std::int64_t time, const double* value) {
    const std::size_t i = samples.at(time);
    if (i == samples.size()) return false;
    return isNearSample(samples, i, time, value) ||
           (i + 1 < samples.size() && isNearSample(samples, i + 1, time, value));
  }
  bool isNearSample(const ColumnSamples& samples, std::size_t i, std::int64_t time,
                    const double* value) {
    if (std::abs(samples.time(i) - time) > reach_ || !samples.isStated(i)) return false;
    if (column_.width() == 1) {
      const double its = std::abs(apartOf(column_.kind, value, samples.value(i))[0]);
      apparent_ = std::max(apparent_, its);
      return its <= measures_.front().limit;
    }
    const Apart apart = apartOf(column_.kind, value, samples.value(i));
    return std::ranges::all_of(measures_, [&](const ColumnMeasure& measure) {
      double square = 0;
      for (std::size_t c = 0; c < measure.components; ++c) {
        square += apart[measure.first_component + c] * apart[measure.first_component + c];
      }
      return square <= measure.limit * measure.limit;
    });
  }

  static void add(ApartRange& band, const ApartRange& other) {
    if (!other.any) return;
    band.add(other.least);
    band.add(other.most);
  }

  /// How far 0, which is the value itself, is from a range.
  static double beyond(const ApartRange& range, const ColumnMeasure& measure,
                       const Apart& allowed) {
    double square = 0;
    for (std::size_t c = measure.first_component; c < measure.first_component + measure.components;
         ++c) {
      const double out = std::max({range.least[c], -range.most[c], 0.0}) - allowed[c];
      // Squares of what a signal may have underflow, or overflow.
      if (measure.components == 1) return std::max(out, 0.0);
      if (out > 0) square += out * out;
    }
    return std::sqrt(square);
  }
  double largestBeyond(const ApartRange& range) const {
    double most = 0;
    for (const ColumnMeasure& measure : measures_) {
      most = std::max(most, beyond(range, measure, {}) - measure.limit);
    }
    return most;
  }

  /// True when all accepted sessions have the value about its time, or do not tell.
  bool isCommon(std::size_t session, std::int64_t time, const double* value) {
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      const ColumnSamples& its = accepted_[k];
      if (k == session || its.size() == 0 || time < its.time(0)) continue;
      if (isNear(its, time, value)) continue;
      const ApartRange around = its.wideRange(time - reach_, time + reach_, value);
      if (!around.any || largestBeyond(around) > 0) return false;
    }
    return true;
  }

  /// What the run has beside one accepted value, beside those of all sessions instead: where they
  /// differ, the run is as far away as from the nearest.
  ApartRange fromAll(std::size_t session, const ApartRange& around, std::int64_t time,
                     const double* value) const {
    ApartRange points;
    points.add(Apart{});
    double other[7];
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      if (k == session || !accepted_[k].valueAt(time, other)) continue;
      points.add(apartOf(column_.kind, value, other));
    }
    ApartRange nearest = around;
    for (std::size_t c = 0; c < nearest.least.size(); ++c) {
      nearest.least[c] -= points.most[c];
      nearest.most[c] -= points.least[c];
    }
    return nearest;
  }

  /// Both sessions end here; what the run would have had a little later is unknown.
  bool isAtEndOfBoth(std::int64_t time) const {
    const std::int64_t end = times_.runEnd();
    return std::abs(end - times_.end()) <= 2 * reach_ && time > end - reach_;
  }

  /// Where the run lost packets: how far the accepted session is from a straight line between what
  /// it has at the ends of the gap.
  Apart lostAt(const ColumnSamples& its, std::int64_t time, const double* value) const {
    std::int64_t from = 0;
    std::int64_t until = 0;
    double before[7], after[7], line[7];
    if (!run_.isLost(time, from, until) || !its.valueAt(from, before) ||
        !its.valueAt(until, after)) {
      return {};
    }
    const double part = static_cast<double>(time - from) / static_cast<double>(until - from);
    interpolate(column_, before, after, part, line);
    Apart apart = apartOf(column_.kind, line, value);
    for (double& component : apart) component = std::abs(component);
    return apart;
  }

  void judgeAbsence(std::size_t session, std::int64_t time) {
    const bool may_be_absent = std::ranges::any_of(accepted_, [&](const ColumnSamples& its) {
      const std::size_t i = its.at(time);
      return &its != &accepted_[session] && its.size() > 0 && (i == its.size() || !its.isStated(i));
    });
    if (may_be_absent || time < times_.runBegin()) {
      absent_.reset();
      return;
    }
    if (!absent_) absent_ = time;
    noteAbsence(time);
  }
  void noteAbsence(std::int64_t until) {
    if (until - *absent_ > kAbsent && (!absent_since_ || *absent_ < *absent_since_)) {
      absent_since_ = absent_;
    }
  }

  void note(const ApartRange& range, std::int64_t time, const Apart& allowed) {
    noteAs(&ColumnMeasure::largest, &ColumnMeasure::at, range, time, allowed);
  }

  /// The same of a value that all accepted sessions have and the run misses, though it is as near
  /// as the nearest of them: it counts for the limit, and as the figure where there is no other.
  void noteMissing(const ApartRange& range, std::int64_t time, const Apart& allowed) {
    noteAs(&ColumnMeasure::missing, &ColumnMeasure::missing_at, range, time, allowed);
  }
  void noteAs(double ColumnMeasure::*figure, std::int64_t ColumnMeasure::*when,
              const ApartRange& range, std::int64_t time, const Apart& allowed) {
    bool is_beyond = false;
    for (ColumnMeasure& measure : measures_) {
      const double its = beyond(range, measure, allowed);
      if (!(its > measure.limit)) continue;
      is_beyond = true;
      if (!measure.first || time < *measure.first) measure.first = time;
      measure.last = std::max(measure.last, time);
      if (its <= measure.*figure) continue;
      measure.*figure = its;
      measure.*when = time;
    }
    failing_ = is_beyond ? failing_ + 1 : 0;
    if (!is_beyond) return;
    if (!stretch_) stretch_ = {time, time};
    stretch_->second = time;
  }

  /// Packets of one side were beyond a limit, one after another, and are not at `time`: what they
  /// said held until then, or until the other side came to it.
  void endStretch(std::int64_t time, const ColumnSamples& own, const ColumnSamples& others) {
    if (!stretch_) return;
    const auto [from, last] = *std::exchange(stretch_, std::nullopt);
    double value[7];
    std::size_t i = others.at(last);
    for (i = i == others.size() ? 0 : i + 1; i < others.size() && others.time(i) < time; ++i) {
      const std::int64_t at = others.time(i);
      if (!others.isStated(i) || !own.valueAt(at, value)) continue;
      if (isNearSample(others, i, at, value)) time = at;
    }
    spans_.push_back({times_.sinceOrigin(from), times_.sinceOrigin(std::max(last, time))});
  }

  void addFindings(std::vector<RunFinding>& findings) {
    const JudgedColumn judged{times_, item_, column_, accepted_, run_};
    if (absent_since_) {
      RunFinding finding = findingAt(judged, *absent_since_);
      finding.spans = {{finding.first_accepted, times_.sinceOrigin(times_.end())}};
      finding.what = fmt::format("{}: no value from {}", item_, times_.bothTimes(*absent_since_));
      findings.push_back(std::move(finding));
      return;
    }
    const std::vector<RunSpan> spans = joined(std::move(spans_), Nanoseconds(reach_));
    for (ColumnMeasure& measure : measures_) {
      if (measure.largest == 0) {
        measure.largest = measure.missing;
        measure.at = measure.missing_at;
      }
      if (!measure.first) continue;
      findings.push_back(findingOf(judged, measure, reach_));
      findings.back().spans = spans;
    }
  }

  const RunTimes& times_;
  std::string item_;
  const TrackColumn& column_;
  const std::vector<ColumnSamples>& accepted_;
  const ColumnSamples& run_;
  std::vector<ColumnMeasure> measures_;
  std::int64_t reach_ = 0, from_ = 0, until_ = 0;
  bool has_masks_ = false;
  std::uint64_t values_ = 0;
  std::size_t failing_ = 0;   ///< packets in a row that are beyond a limit
  std::int64_t weighed_ = 0;  ///< the last packet that was weighed
  double apparent_ = 0;       ///< how far the value is from the packets next to it
  std::optional<std::pair<std::int64_t, std::int64_t>> stretch_;  ///< beyond a limit, so far
  std::vector<RunSpan> spans_;
  std::optional<std::int64_t> absent_, absent_since_;
};

}  // namespace

ColumnOutcome judgeColumn(const RunTimes& times, const std::string& item, const TrackColumn& column,
                          const std::vector<ColumnSamples>& accepted, const ColumnSamples& run,
                          std::vector<RunFinding>& findings) {
  ColumnJudge judge(times, item, column, accepted, run);
  ColumnOutcome outcome;
  judge.judge(findings);
  outcome.values = judge.values();
  outcome.fastest = judge.fastest();
  return outcome;
}

}  // namespace rocinante
