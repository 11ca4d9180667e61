#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/behaviour/run_coverage.h"
#include "core/behaviour/run_judge.h"

namespace rocinante {
namespace {

const FactChange kNothing{};
/// What a session first states so soon after its beginning may have been so before.
constexpr Nanoseconds kBeginning = std::chrono::seconds(2);

/// The statements about one thing in one session, on the time line of the first accepted one.
class FactHistory {
 public:
  struct Change {
    std::int64_t at = 0;
    const FactChange* change = nullptr;
  };

  FactHistory(const RunTimes& times, const SessionTrack& track, const TimeMap& map,
              const std::string& fact) {
    const auto onLine = [&](LogTime time) {
      return (map.inAccepted(time) - times.first().start).count();
    };
    begin_ = onLine(track.start);
    const auto found = track.facts.find(fact);
    if (found == track.facts.end() || found->second.empty()) {
      known_from_ = begin_;
      return;
    }
    for (const FactChange& change : found->second) changes_.push_back({onLine(change.at), &change});
    const FactChange& first = found->second.front();
    const bool was_before = first.is_restated || first.at - track.start <= kBeginning;
    known_from_ = was_before ? changes_.front().at : begin_;
  }

  const std::vector<Change>& changes() const { return changes_; }
  /// Before that it is not known.
  std::int64_t knownFrom() const { return known_from_; }
  const FactChange& at(std::int64_t time) const { return get(placeOf(time)); }
  std::int64_t begin() const { return begin_; }
  /// The last one at or before a time; null: none.
  const Change* lastChange(std::int64_t time) const {
    const std::size_t place = placeOf(time);
    return place == 0 ? nullptr : &changes_[place - 1];
  }
  /// When it becomes `wanted` behind a time, at `end` the latest.
  template <class Wanted>
  std::optional<std::int64_t> nextChange(std::int64_t time, std::int64_t end, Wanted wanted) const {
    for (std::size_t place = placeOf(time); place < changes_.size(); ++place) {
      if (changes_[place].at > end) break;
      if (wanted(*changes_[place].change)) return changes_[place].at;
    }
    return std::nullopt;
  }
  /// Nothing was stated yet, so soon after the session's beginning that it may have been before.
  bool isUnsaid(std::int64_t time) const {
    return placeOf(time) == 0 && time < begin_ + kBeginning.count();
  }
  /// What holds at a time was stated before another one.
  bool wasSaidBefore(std::int64_t other, std::int64_t time) const {
    const std::size_t place = placeOf(time);
    return place > 0 && changes_[place - 1].at < other;
  }
  /// True when something in [from, until] is `wanted`, or is not known there.
  template <class Wanted>
  bool mayIn(std::int64_t from, std::int64_t until, Wanted wanted) const {
    if (from < known_from_) return true;
    for (std::size_t place = placeOf(from); place <= placeOf(until); ++place) {
      if (wanted(get(place))) return true;
    }
    return false;
  }

 private:
  /// 0: nothing was stated yet.
  std::size_t placeOf(std::int64_t time) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(changes_, time, {}, &Change::at) -
                                    changes_.begin());
  }
  const FactChange& get(std::size_t place) const {
    return place == 0 ? kNothing : *changes_[place - 1].change;
  }

  std::vector<Change> changes_;
  std::int64_t begin_ = 0, known_from_ = 0;
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
  FactJudge(const RunTimes& times, const std::string& fact)
      : times_(times), fact_(fact), run_(times, times.run, times.run_map, fact) {
    is_drawing_ = fact.starts_with("drawing/");
    item_ = itemOfFact(fact);
    limits_ = times.spec.limitsOf(item_);
    for (std::size_t k = 0; k < times.accepted.size(); ++k) {
      accepted_.emplace_back(times, *times.accepted[k], times.accepted_maps[k], fact);
    }
    slack_ = times.reachOf(limits_);
  }

  void judge(std::vector<RunFinding>& findings) {
    std::optional<std::int64_t> first;
    std::vector<RunSpan> spans;
    bool goes_on = false;
    for (const std::int64_t time : moments()) {
      const Nanoseconds moment = times_.sinceOrigin(time);
      if (goes_on) spans.back().until = moment;
      goes_on = !times_.spec.isMasked(item_, moment) && !isAsAccepted(time);
      if (!goes_on) continue;
      spans.push_back({moment, moment});
      if (!first) first = time;
    }
    if (!first) return;
    RunFinding finding;
    finding.kind = is_drawing_ ? RunFinding::Kind::drawing : RunFinding::Kind::fact;
    finding.item = item_;
    finding.first_accepted = finding.at_accepted = times_.sinceOrigin(*first);
    finding.first_run = finding.at_run = times_.sinceRunOrigin(*first);
    finding.until_accepted = spans.back().until;
    finding.spans = joined(std::move(spans), Nanoseconds(slack_));
    const FactChange& now = run_.at(*first);
    const FactChange& before = accepted_.front().at(*first);
    const auto apart = shapesApart(now, before);
    if (now.text == before.text && apart && *apart > 0) {
      finding.unit = "mm";
      finding.largest = apart;
      finding.limit = limits_.position_mm;
      finding.what = fmt::format("{}: moved by {}, since {}", textOf(fact_),
                                 figureText(*apart, "mm"), times_.bothTimes(*first));
    } else {
      finding.what = fmt::format("{}: {}, accepted {}, since {}{}", textOf(fact_), valueText(now),
                                 valueText(before), times_.bothTimes(*first), howLate(*first));
    }
    findings.push_back(std::move(finding));
  }

 private:
  /// "; 400 ms late" of a change that one side has about a time and the other at another one; "; it
  /// does not come until the end" of one that the run never has. Empty: neither.
  std::string howLate(std::int64_t time) const {
    const FactHistory::Change* const accepted = accepted_.front().lastChange(time);
    const FactHistory::Change* const now = run_.lastChange(time);
    const bool is_early = now != nullptr && (accepted == nullptr || now->at > accepted->at);
    const FactHistory::Change* const change = is_early ? now : accepted;
    if (change == nullptr) return {};
    const FactHistory& its = is_early ? run_ : accepted_.front();
    const FactHistory& other = is_early ? accepted_.front() : run_;
    const auto isSo = [&](const FactChange& of_other) { return isSame(of_other, *change->change); };
    const std::optional<std::int64_t> comes = other.nextChange(time, times_.end(), isSo);
    const std::optional<std::int64_t> again = its.nextChange(time, times_.end(), isSo);
    if (comes && (!again || *comes < *again - slack_)) {
      return fmt::format("; {} {}",
                         figureText(static_cast<double>(*comes - change->at) * 1e-6, "ms"),
                         is_early ? "early" : "late");
    }
    // Of a log that ends before, its end says more.
    if (comes || is_early || time > times_.runEnd()) return {};
    return change->change->text.empty() ? "; it stays until the end"
                                        : "; it does not come until the end";
  }
  /// "drawing/planner/path part 2"
  static std::string textOf(const std::string& fact) {
    const std::size_t tab = fact.find('\t');
    return tab == std::string::npos ? fact : fact.substr(0, tab) + " part " + fact.substr(tab + 1);
  }
  static std::string valueText(const FactChange& change) {
    if (change.text.empty()) return "nothing";
    // Texts of signals are quoted.
    return change.text.front() == '"' ? change.text : "\"" + change.text + "\"";
  }

  bool isSame(const FactChange& a, const FactChange& b) const {
    if (a.text != b.text) return false;
    const auto apart = shapesApart(a, b);
    return apart && *apart <= limits_.position_mm;
  }

  /// Everything is constant between changes, and about one all is decided within the slack.
  std::vector<std::int64_t> moments() const {
    std::vector<std::int64_t> moments{0, times_.end()};
    const auto add = [&](const FactHistory& history) {
      for (const FactHistory::Change& change : history.changes()) {
        moments.push_back(change.at);
        moments.push_back(change.at + slack_ + 1);
      }
      moments.push_back(history.knownFrom() + slack_);
      moments.push_back(history.begin() + kBeginning.count());
    };
    add(run_);
    for (const FactHistory& history : accepted_) add(history);
    std::erase_if(moments, [&](std::int64_t time) { return time < 0 || time > times_.end(); });
    std::ranges::sort(moments);
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    return moments;
  }

  /// One side stated what holds before the other's log began, and there it was not restated yet.
  bool isBeforeALog(const FactHistory& its, std::int64_t time) const {
    return (run_.isUnsaid(time) && its.wasSaidBefore(run_.begin() + slack_, time)) ||
           (its.isUnsaid(time) && run_.wasSaidBefore(its.begin() + slack_, time));
  }

  bool isAsAccepted(std::int64_t time) const {
    if (time < run_.knownFrom()) return true;
    const FactChange& now = run_.at(time);
    const auto isNow = [&](const FactChange& other) { return isSame(now, other); };
    bool was_accepted = false;
    bool was_reached = false;
    std::size_t unknown = 0;
    for (const FactHistory& history : accepted_) {
      if (isBeforeALog(history, time)) {
        // It says nothing of this moment; others may.
        ++unknown;
        continue;
      }
      was_accepted = was_accepted || history.mayIn(time - slack_, time + slack_, isNow);
      if (was_reached) continue;
      const FactChange& accepted = history.at(time);
      was_reached = time < history.knownFrom() ||
                    run_.mayIn(time - slack_, time + slack_,
                               [&](const FactChange& other) { return isSame(other, accepted); });
    }
    return unknown == accepted_.size() || (was_accepted && was_reached);
  }

  const RunTimes& times_;
  const std::string& fact_;
  bool is_drawing_ = false;
  std::string item_;
  RunLimits limits_;
  std::int64_t slack_ = 0;
  FactHistory run_;
  std::vector<FactHistory> accepted_;
};

}  // namespace

void judgeFact(const RunTimes& times, const std::string& fact, std::vector<RunFinding>& findings) {
  FactJudge(times, fact).judge(findings);
}

}  // namespace rocinante
