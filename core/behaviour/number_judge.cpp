#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/behaviour/motion_judge.h"
#include "core/behaviour/run_coverage.h"

namespace rocinante {
namespace {

constexpr const char* kNoisySignal =
    "its limit is as large as its range: no value in it is different";

struct NumberToJudge {
  std::string item;
  std::vector<RunFinding> findings;
  ColumnOutcome outcome;
  bool is_blind = false;
};

/// The first that an accepted session says.
std::string unitOf(const RunTimes& times, const std::string& item) {
  for (const SessionTrack* track : times.accepted) {
    const auto fact = track->facts.find(unitFact(item));
    if (fact == track->facts.end()) continue;
    for (const FactChange& change : fact->second) {
      if (!change.text.empty()) return change.text;
    }
  }
  return {};
}

void judge(const RunTimes& times, NumberToJudge& number) {
  TrackColumn column;
  column.kind = TrackColumn::Kind::number;
  column.is_stated = true;
  column.unit = unitOf(times, number.item);
  std::vector<std::vector<std::int64_t>> lines;
  lines.reserve(times.accepted.size() + 1);
  const auto samplesOf = [&](const SessionTrack& track, const TimeMap& map) {
    const auto found = track.numbers.find(number.item);
    if (found == track.numbers.end()) return ColumnSamples();
    lines.push_back(alignedTimes(track, found->second, map, times.first().start));
    return ColumnSamples(track, found->second, column, lines.back());
  };
  std::vector<ColumnSamples> accepted;
  for (std::size_t i = 0; i < times.accepted.size(); ++i) {
    accepted.push_back(samplesOf(*times.accepted[i], times.accepted_maps[i]));
  }
  const ColumnSamples run = samplesOf(times.run, times.run_map);
  number.outcome = judgeColumn(times, number.item, column, accepted, run, number.findings);
  const RunLimits limits = times.spec.limitsOf(number.item);
  LearntLimit limit = learntLimit(limits, accepted);
  limit.limit = limits.signal.value_or(limit.limit);
  number.is_blind = limit.isBlind();
}

}  // namespace

LearntLimit learntLimit(const RunLimits& limits, const std::vector<ColumnSamples>& accepted) {
  constexpr double kDeviations = 6;  // of the difference of two values, 4.2
  constexpr double kRounding = 1e-14;
  std::optional<std::pair<double, double>> all;
  double noise = 0;
  for (const ColumnSamples& its : accepted) {
    if (its.size() == 0) continue;
    const auto [least, most] = its.extremes();
    all = std::pair(std::min(least, all ? all->first : least),
                    std::max(most, all ? all->second : most));
    noise = std::max(noise, its.noise());
  }
  if (!all) return {};
  const double range = std::min(all->second - all->first, std::numeric_limits<double>::max());
  const double largest = std::max(std::abs(all->first), std::abs(all->second));
  return {limits.signal_share * range + kDeviations * noise + kRounding * largest, range};
}

void judgeNumbers(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged) {
  std::set<std::string> items;
  times.eachSession([&](const SessionTrack& track) {
    for (const auto& [item, series] : track.numbers) items.insert(item);
  });
  std::vector<NumberToJudge> numbers;
  for (const std::string& item : items) {
    if (times.spec.isMaskedThroughout(item)) continue;
    const auto has = [&](const SessionTrack* track) { return track->numbers.contains(item); };
    const bool is_accepted = std::ranges::any_of(times.accepted, has);
    if (is_accepted && has(&times.run)) {
      numbers.push_back({item, {}, {}, false});
      continue;
    }
    if (is_accepted && !std::ranges::all_of(times.accepted, has)) continue;
    RunFinding finding = times.findingOfAll(
        is_accepted ? RunFinding::Kind::coverage : RunFinding::Kind::signal, item);
    finding.what =
        fmt::format("{}: {}", item,
                    is_accepted ? "not judged, since the session states no number of it"
                                : "no accepted session states a number of it; this one does");
    // Known as a state before, and the fact says so; or made by an import that does more now.
    const bool is_state = times.run.facts.contains(item) ||
                          std::ranges::any_of(times.accepted, [&](const SessionTrack* track) {
                            return track->facts.contains(item);
                          });
    if (!is_accepted && !is_state && times.run.is_imported) {
      judged.coverage.left_out.leaveOut({"signal", item, kNotAcceptedSignal});
    } else {
      judged.findings.push_back(std::move(finding));
    }
  }
  forEachIndex(parallel, numbers.size(), [&](std::size_t i) { judge(times, numbers[i]); });
  for (NumberToJudge& number : numbers) {
    std::ranges::move(number.findings, std::back_inserter(judged.findings));
    if (number.is_blind) judged.coverage.left_out.leaveOut({"signal", number.item, kNoisySignal});
    judged.values += number.outcome.values;
  }
}

}  // namespace rocinante
