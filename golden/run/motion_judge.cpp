#include "golden/run/motion_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "golden/run/motion_words.h"
#include "golden/run/run_coverage.h"
#include "golden/run/run_curve.h"
#include "golden/run/value_difference.h"

namespace rocinante {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Values of one column in one session, by sample; see AlignedGrid::values.
struct ColumnValues {
  std::vector<double> numbers;
  std::size_t width = 1;

  const double* at(std::size_t sample) const {
    return numbers.data() + (numbers.size() == width ? 0 : sample * width);
  }
  bool isConstant() const { return numbers.size() == width; }
};

/// The deviation of one measure of a column over time.
struct Measure {
  const char* unit = "°";
  double limit = 0;
  std::size_t first_component = 0, components = 1;
  std::optional<std::size_t> first;
  std::size_t at = 0, last = 0, beyond = 0;
  double largest = 0;
  double signed_largest = 0;
};

class ColumnJudge {
 public:
  ColumnJudge(const RunGrids& grids, const std::string& device, const TrackColumn& column)
      : grids_(grids), device_(device), column_(column) {
    item_ = itemOf(device, column);
    limits_ = grids.spec.limitsOf(item_);
    reach_ = grids.reachOf(limits_);
    if (column.width() == 7) {
      measures_.push_back({"mm", limits_.position_mm, 0, 3, {}, 0, 0, 0, 0, 0});
      measures_.push_back({"°", limits_.turn_deg, 3, 3, {}, 0, 0, 0, 0, 0});
    } else if (column.kind == TrackColumn::Kind::length) {
      measures_.push_back({"mm", limits_.position_mm, 0, 1, {}, 0, 0, 0, 0, 0});
    } else {
      measures_.push_back({"°", limits_.joint_deg, 0, 1, {}, 0, 0, 0, 0, 0});
    }
  }

  std::size_t judge(std::vector<RunFinding>& findings) {
    load();
    if (std::ranges::all_of(accepted_, [](const ColumnValues& its) { return neverStated(its); })) {
      return 0;
    }
    if (run_.isConstant() && std::ranges::all_of(accepted_, &ColumnValues::isConstant)) {
      constant_ = true;
    }
    // Not stated for a while at the start is a matter of when the recorder was started.
    const std::size_t count = constant_ ? 1 : grids_.run_grid.size();
    // Nearer to an end than a value may be late or early, the motion before or after is unknown.
    const std::size_t edge = count > 4 * reach_ ? reach_ : 0;
    for (std::size_t i = edge; i < count - edge; ++i) {
      if (!grids_.spec.isMasked(item_, grids_.sinceOrigin(i))) judgeSample(i);
    }
    addFindings(findings);
    return measures_.size();
  }

 private:
  static bool neverStated(const ColumnValues& values) {
    return values.isConstant() && std::isnan(values.numbers.front());
  }

  void load() {
    const bool is_link = column_.kind == TrackColumn::Kind::link_pose;
    const auto valuesOf = [&](const SessionTrack& track, const AlignedGrid& grid) {
      ColumnValues values;
      values.width = column_.width();
      const auto device = track.devices.find(device_);
      const TrackColumn* its =
          device == track.devices.end() ? nullptr : device->second.find(column_.part, is_link);
      if (its != nullptr && its->kind == column_.kind) {
        values.numbers = grid.values(&device->second, its);
      } else {
        values.numbers.assign(values.width, std::numeric_limits<double>::quiet_NaN());
      }
      return values;
    };
    for (std::size_t i = 0; i < grids_.accepted.size(); ++i) {
      accepted_.push_back(valuesOf(*grids_.accepted[i], grids_.accepted_grids[i]));
    }
    run_ = valuesOf(grids_.run, grids_.run_grid);
  }

  /// Around a sample, as far as a value may come earlier or later.
  ApartRange rangeOf(const ColumnValues& values, const double* reference,
                     std::size_t sample) const {
    ApartRange range;
    if (values.isConstant()) {
      if (!std::isnan(values.numbers.front())) {
        range.add(apartOf(column_.kind, reference, values.at(0)));
      }
      return range;
    }
    const std::size_t first = sample < reach_ ? 0 : sample - reach_;
    const std::size_t last = std::min(sample + reach_, grids_.run_grid.size() - 1);
    for (std::size_t i = first; i <= last; ++i) {
      if (std::isnan(values.at(i)[0])) continue;
      range.add(apartOf(column_.kind, reference, values.at(i)));
    }
    return range;
  }

  void judgeSample(std::size_t i) {
    const double* reference = nullptr;
    bool may_be_absent = false;
    for (const ColumnValues& values : accepted_) {
      const double* const its = values.at(i);
      may_be_absent = may_be_absent || std::isnan(its[0]);
      if (reference == nullptr && !std::isnan(its[0])) reference = its;
    }
    if (reference == nullptr) return;
    const double* const own = run_.at(i);
    if (std::isnan(own[0])) {
      if (!may_be_absent) noteAbsence(i);
      return;
    }
    absent_ = 0;
    ApartRange band, points;
    for (const ColumnValues& values : accepted_) {
      if (std::isnan(values.at(i)[0])) continue;
      const ApartRange around = rangeOf(values, reference, i);
      band.add(around.least);
      band.add(around.most);
      points.add(apartOf(column_.kind, reference, values.at(i)));
    }
    const Apart apart = apartOf(column_.kind, reference, own);
    const ApartRange around = rangeOf(run_, reference, i);
    std::optional<Apart> unseen;  // only where it matters
    for (Measure& measure : measures_) {
      double square = 0;
      double sign = 0;
      for (std::size_t c = measure.first_component;
           c < measure.first_component + measure.components; ++c) {
        // Outside the band, or the band was never reached although every accepted run did.
        const double above = std::max(apart[c] - band.most[c], around.least[c] - points.most[c]);
        const double below = std::max(band.least[c] - apart[c], points.least[c] - around.most[c]);
        double beyond = std::max({above, below, 0.0});
        if (beyond > measure.limit) {
          if (!unseen) unseen = unseenAt(i, reference);
          beyond = std::max(0.0, beyond - (*unseen)[c] -
                                     std::min(unseenInRun(i, reference, c), measure.limit / 2));
        }
        sign = above >= below ? 1 : -1;
        square += beyond * beyond;
      }
      note(measure, i, std::sqrt(square), sign);
    }
    // A curve is drawn beside the first accepted session.
    if (measures_.size() == 1 && reference == accepted_.front().at(i))
      curve_.add(i, band.least[0], band.most[0], apart[0]);
  }

  /// How far the accepted ones may have gone between samples: where a motion turns sharply, its
  /// peak lies between two of them.
  Apart unseenAt(std::size_t i, const double* reference) const {
    Apart most{};
    for (const ColumnValues& values : accepted_) {
      const Apart its = unseenOf(values, i, reference);
      for (std::size_t c = 0; c < most.size(); ++c) most[c] = std::max(most[c], its[c]);
    }
    return most;
  }
  double unseenInRun(std::size_t i, const double* reference, std::size_t c) const {
    return unseenOf(run_, i, reference)[c];
  }
  Apart unseenOf(const ColumnValues& values, std::size_t sample, const double* reference) const {
    Apart most{};
    if (values.isConstant()) return most;
    const std::size_t last = grids_.run_grid.size() - 1;
    for (std::size_t i = std::max<std::size_t>(sample, reach_ + 1) - reach_;
         i <= sample + reach_ && i + 1 <= last; ++i) {
      const Apart before = apartOf(column_.kind, reference, values.at(i - 1));
      const Apart here = apartOf(column_.kind, reference, values.at(i));
      const Apart after = apartOf(column_.kind, reference, values.at(i + 1));
      for (std::size_t c = 0; c < most.size(); ++c) {
        const double bend = std::abs(before[c] + after[c] - 2 * here[c]) / 2;
        if (bend > most[c]) most[c] = bend;
      }
    }
    return most;
  }

  void noteAbsence(std::size_t i) {
    const auto tolerated = static_cast<std::size_t>(std::chrono::seconds(1) / grids_.first().step);
    ++absent_;
    if (absent_ <= tolerated && !constant_) return;
    if (!absent_since_) absent_since_ = i >= absent_ ? i - absent_ + 1 : 0;
  }

  static void note(Measure& measure, std::size_t i, double beyond, double sign) {
    if (beyond > measure.largest) {
      measure.largest = beyond;
      measure.signed_largest = sign * beyond;
      measure.at = i;
    }
    if (!(beyond > measure.limit)) return;
    if (!measure.first) measure.first = i;
    measure.last = i;
    ++measure.beyond;
  }

  void addFindings(std::vector<RunFinding>& findings) {
    if (absent_since_) {
      RunFinding finding = findingAt(*absent_since_);
      finding.what = fmt::format("{}: no value from {}", item_, grids_.bothTimes(*absent_since_));
      findings.push_back(std::move(finding));
      return;
    }
    for (const Measure& measure : measures_) {
      if (!measure.first) continue;
      RunFinding finding = findingAt(*measure.first);
      finding.unit = measure.unit;
      finding.limit = measure.limit;
      finding.largest = measure.largest;
      finding.at_accepted = grids_.sinceOrigin(measure.at);
      finding.at_run = grids_.inRun(measure.at);
      finding.until_accepted = grids_.sinceOrigin(measure.last);
      finding.what = sentence(measure);
      if (measures_.size() == 1) {
        finding.curve =
            curve_.reduced(grids_, scalarScale(), accepted_.front().numbers, measure.limit);
      }
      findings.push_back(std::move(finding));
    }
  }

  double scalarScale() const {
    return column_.kind == TrackColumn::Kind::length ? kMillimetres : kDegrees;
  }

  std::string sentence(const Measure& measure) const {
    const std::string figure = figureText(measure.largest, measure.unit);
    std::string text = fmt::format("{}: {} beyond what was accepted, since {}", item_, figure,
                                   grids_.bothTimes(*measure.first));
    if (measure.at != *measure.first) {
      text += fmt::format("; largest at {}", grids_.bothTimes(measure.at));
    }
    if (measures_.size() == 1 && !constant_) {
      const MotionShape shape{run_.numbers,
                              accepted_.front().numbers,
                              *measure.first,
                              measure.last,
                              secondsOf(grids_.first().step),
                              scalarScale(),
                              measure.limit,
                              measure.unit};
      const std::string how = howItDiffers(shape);
      if (!how.empty()) text += "; " + how;
    }
    return text;
  }

  RunFinding findingAt(std::size_t sample) const {
    RunFinding finding;
    finding.kind = column_.width() == 7 ? RunFinding::Kind::pose : RunFinding::Kind::joint;
    finding.item = item_;
    finding.first_accepted = finding.at_accepted = finding.until_accepted =
        grids_.sinceOrigin(sample);
    finding.first_run = finding.at_run = grids_.inRun(sample);
    return finding;
  }

  const RunGrids& grids_;
  const std::string& device_;
  const TrackColumn& column_;
  std::string item_;
  RunLimits limits_;
  std::size_t reach_ = 1;
  std::vector<Measure> measures_;
  std::vector<ColumnValues> accepted_;
  ColumnValues run_;
  bool constant_ = false;
  std::size_t absent_ = 0;
  std::optional<std::size_t> absent_since_;
  CurveKeeper curve_;
};

}  // namespace

Nanoseconds RunGrids::inRun(std::size_t sample) const {
  return std::clamp(run_grid.time(sample), run.start, run.end) - run.origin;
}

std::size_t RunGrids::reachOf(const RunLimits& limits) const {
  const double step_ms = secondsOf(first().step) * 1e3;
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil(limits.event_ms / step_ms - 1e-9)));
}

std::string RunGrids::bothTimes(std::size_t sample) const {
  return fmt::format("{:.3f} s (accepted {:.3f} s)", secondsOf(inRun(sample)),
                     secondsOf(sinceOrigin(sample)));
}

std::size_t judgeColumn(const RunGrids& grids, const std::string& device, const TrackColumn& column,
                        std::vector<RunFinding>& findings) {
  return ColumnJudge(grids, device, column).judge(findings);
}

void judgeRate(const RunGrids& grids, const std::string& device,
               std::vector<RunFinding>& findings) {
  // A rate is another one when it is beyond these times the accepted ones, and by two packets.
  constexpr double kLeast = 0.67;
  constexpr double kMax = 1.5;
  constexpr double kSlack = 2;
  const auto window = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::chrono::seconds(1) / grids.first().step));
  std::vector<std::vector<double>> accepted;
  for (std::size_t k = 0; k < grids.accepted.size(); ++k) {
    const auto found = grids.accepted[k]->devices.find(device);
    if (found == grids.accepted[k]->devices.end()) return;
    accepted.push_back(grids.accepted_grids[k].updatesBefore(found->second));
  }
  const auto its = grids.run.devices.find(device);
  if (its == grids.run.devices.end()) return;
  const std::vector<double> own = grids.run_grid.updatesBefore(its->second);
  std::optional<std::size_t> first, worst;
  std::size_t in_a_row = 0, last = 0;
  double worst_ratio = 1;
  std::array<double, 3> figures{};
  const auto judge = [&](std::size_t from, std::size_t until, std::size_t needed) {
    double least = kInfinite;
    double most = 0;
    for (const std::vector<double>& sums : accepted) {
      least = std::min(least, sums[until] - sums[from]);
      most = std::max(most, sums[until] - sums[from]);
    }
    const double count = own[until] - own[from];
    const bool is_beyond = count < kLeast * least - kSlack || count > kMax * most + kSlack;
    in_a_row = is_beyond ? in_a_row + 1 : 0;
    if (!is_beyond || grids.spec.isMasked(device, grids.sinceOrigin(from))) return;
    if (in_a_row < needed) return;
    if (!first) first = from + window >= in_a_row * window ? from + window - in_a_row * window : 0;
    last = until;
    const double ratio = count < least ? count / least : most / std::max(count, 1.0);
    if (worst && ratio >= worst_ratio) return;
    worst = from;
    worst_ratio = ratio;
    const double seconds = secondsOf(grids.first().step) * static_cast<double>(until - from);
    figures = {count / seconds, least / seconds, most / seconds};
  };
  for (std::size_t from = 0; from + window < own.size(); from += window) {
    judge(from, from + window, 2);
  }
  if (!first) {
    in_a_row = 0;
    judge(0, own.size() - 1, 1);
  }
  if (!first) return;
  RunFinding finding;
  finding.kind = RunFinding::Kind::rate;
  finding.item = device;
  finding.unit = "/s";
  finding.largest = figures[0] < figures[1] ? figures[1] - figures[0] : figures[0] - figures[2];
  finding.first_accepted = grids.sinceOrigin(*first);
  finding.first_run = grids.inRun(*first);
  finding.at_accepted = grids.sinceOrigin(*worst);
  finding.at_run = grids.inRun(*worst);
  finding.until_accepted = grids.sinceOrigin(last);
  const double accepted_rate = figures[0] < figures[1] ? figures[1] : figures[2];
  finding.what = fmt::format("{}: stated {:.1f} times a second, accepted {:.1f}, since {}", device,
                             figures[0], accepted_rate, grids.bothTimes(*first));
  findings.push_back(std::move(finding));
}

}  // namespace rocinante
