#include "golden/run/fact_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "golden/run/run_coverage.h"

namespace rocinante {
namespace {

const FactChange kNothing{};

/// The statements about one thing in one session.
class FactHistory {
 public:
  FactHistory(const SessionTrack& track, const std::string& fact) {
    if (const auto found = track.facts.find(fact); found != track.facts.end()) {
      changes_ = &found->second;
    }
  }

  std::size_t size() const { return changes_ == nullptr ? 0 : changes_->size(); }
  const FactChange& at(LogTime time) const { return get(placeOf(time)); }
  /// True when something in [from, until] is `wanted`.
  template <class Wanted>
  bool anyIn(LogTime from, LogTime until, Wanted wanted) const {
    for (std::size_t place = placeOf(from); place <= placeOf(until); ++place) {
      if (wanted(get(place))) return true;
    }
    return false;
  }

 private:
  /// 0: nothing was stated yet.
  std::size_t placeOf(LogTime time) const {
    if (changes_ == nullptr) return 0;
    return static_cast<std::size_t>(std::ranges::upper_bound(*changes_, time, {}, &FactChange::at) -
                                    changes_->begin());
  }
  const FactChange& get(std::size_t place) const {
    return place == 0 ? kNothing : (*changes_)[place - 1];
  }

  const std::vector<FactChange>* changes_ = nullptr;
};

/// Millimetres between two shapes of as many points; empty when they have not as many.
std::optional<double> shapesApart(const FactChange& a, const FactChange& b) {
  if (a.shape.size() != b.shape.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < a.shape.size(); ++i) {
    most = std::max(most, std::abs(a.shape[i] - b.shape[i]) * 1000);
  }
  return most;
}

class FactJudge {
 public:
  FactJudge(const RunGrids& grids, const std::string& fact)
      : grids_(grids), fact_(fact), run_(grids.run, fact) {
    is_drawing_ = fact.starts_with("drawing/");
    item_ = itemOfFact(fact);
    limits_ = grids.spec.limitsOf(item_);
    for (const SessionTrack* track : grids.accepted) accepted_.emplace_back(*track, fact);
    // Facts are read once a sample, and half of the bound is rounding to samples.
    slack_ = Nanoseconds(std::llround(limits_.event_ms * 1e6)) + 2 * grids.first().step;
  }

  void judge(std::vector<RunFinding>& findings) {
    std::optional<std::size_t> first, last;
    for (std::size_t i = 0; i < grids_.run_grid.size(); ++i) {
      if (grids_.spec.isMasked(item_, grids_.sinceOrigin(i)) || isAsAccepted(i)) continue;
      if (!first) first = i;
      last = i;
    }
    if (!first) return;
    RunFinding finding;
    finding.kind = is_drawing_ ? RunFinding::Kind::drawing : RunFinding::Kind::fact;
    finding.item = item_;
    finding.first_accepted = finding.at_accepted = grids_.sinceOrigin(*first);
    finding.first_run = finding.at_run = grids_.inRun(*first);
    finding.until_accepted = grids_.sinceOrigin(*last);
    const FactChange& now = run_.at(grids_.run_grid.time(*first));
    const FactChange& before = accepted_.front().at(grids_.firstTime(*first));
    const auto apart = shapesApart(now, before);
    if (now.text == before.text && apart && *apart > 0) {
      finding.unit = "mm";
      finding.largest = apart;
      finding.limit = limits_.position_mm;
      finding.what = fmt::format("{}: moved by {}, since {}", fact_, figureText(*apart, "mm"),
                                 grids_.bothTimes(*first));
    } else {
      finding.what = fmt::format("{}: {}, accepted {}, since {}", fact_, said(now), said(before),
                                 grids_.bothTimes(*first));
    }
    findings.push_back(std::move(finding));
  }

 private:
  static std::string said(const FactChange& change) {
    return change.text.empty() ? "nothing" : "\"" + change.text + "\"";
  }

  bool isSame(const FactChange& a, const FactChange& b) const {
    if (a.text != b.text) return false;
    const auto apart = shapesApart(a, b);
    return apart && *apart <= limits_.position_mm;
  }

  bool isAsAccepted(std::size_t i) const {
    const LogTime time = grids_.run_grid.time(i);
    const FactChange& now = run_.at(time);
    const auto isNow = [&](const FactChange& other) { return isSame(now, other); };
    bool was_accepted = false;
    bool was_reached = false;
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      const LogTime accepted_time = grids_.accepted_grids[k].time(i);
      was_accepted =
          was_accepted || accepted_[k].anyIn(accepted_time - slack_, accepted_time + slack_, isNow);
      if (was_reached) continue;
      const FactChange& accepted_now = accepted_[k].at(accepted_time);
      was_reached = run_.anyIn(time - slack_, time + slack_, [&](const FactChange& other) {
        return isSame(other, accepted_now);
      });
    }
    return was_accepted && was_reached;
  }

  const RunGrids& grids_;
  const std::string& fact_;
  bool is_drawing_ = false;
  std::string item_;
  RunLimits limits_;
  Nanoseconds slack_{0};
  FactHistory run_;
  std::vector<FactHistory> accepted_;
};

}  // namespace

void judgeFact(const RunGrids& grids, const std::string& fact, std::vector<RunFinding>& findings) {
  FactJudge(grids, fact).judge(findings);
}

}  // namespace rocinante
