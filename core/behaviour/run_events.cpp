#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/duration_text.h"
#include "core/behaviour/run_coverage.h"
#include "core/behaviour/run_judge.h"

namespace rocinante {
namespace {

using Moments = std::vector<std::optional<LogTime>>;

std::string timeText(Nanoseconds since_origin) {
  return fmt::format("{:.3f} s", secondsOf(since_origin));
}

/// By event of the first accepted session: when the other one has it.
Moments momentsOf(const std::vector<Event>& events, const EventAlignment& alignment) {
  Moments moments(events.size());
  auto matched = alignment.matched.begin();
  for (std::size_t i = 0; i < events.size() && matched != alignment.matched.end(); ++i) {
    if (events[i].time != matched->a || events[i].text != matched->text) continue;
    moments[i] = matched->b;
    ++matched;
  }
  return moments;
}

std::vector<TimeMap::Knot> knotsOf(const std::vector<Event>& events, const Moments& moments) {
  std::vector<TimeMap::Knot> knots;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (moments[i]) knots.push_back({events[i].time, *moments[i]});
  }
  return knots;
}

/// `own`: times of the other session by event; those of `left_out` are no knots.
TimeMap mapOf(RunAlign align, const SessionTrack& first, const SessionTrack& other,
              const Moments& own, const std::vector<bool>& left_out) {
  Moments used = own;
  for (std::size_t i = 0; i < used.size() && i < left_out.size(); ++i) {
    if (left_out[i]) used[i].reset();
  }
  TimeMap map;
  map.knots = knotsOf(first.events, used);
  const double rate = clockRate(map.knots);
  if (align == RunAlign::origin || map.knots.empty()) {
    map.knots = {{first.origin, other.origin}};
    map.rate = rate;
  }
  return map;
}

class EventJudge {
 public:
  EventJudge(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
             const SessionTrack& run, RunEvents& found)
      : spec_(spec), accepted_(accepted), first_(*accepted.front()), run_(run), found_(found) {}

  void judge() {
    Moments own;
    for (const Event& event : first_.events) own.push_back(event.time);
    moments_.push_back(own);
    for (std::size_t i = 1; i < accepted_.size(); ++i) {
      found_.accepted.push_back(
          alignEvents(first_.events, accepted_[i]->events, first_.origin, accepted_[i]->origin));
      moments_.push_back(momentsOf(first_.events, found_.accepted.back()));
    }
    for (std::size_t i = 0; i < accepted_.size(); ++i) {
      found_.accepted_maps.push_back(mapOf(spec_.align, first_, *accepted_[i], moments_[i], {}));
    }
    found_.run = alignEvents(first_.events, run_.events, first_.origin, run_.origin);
    new_ = momentsOf(first_.events, found_.run);
    isolated_.resize(first_.events.size());
    judgeTimes();
    found_.run_map = mapOf(spec_.align, first_, run_, new_, isolated_);
    judgeMissing();
    judgeExtra();
  }

 private:
  /// How much later event `i` comes than any accepted one, counted from `base`, or from the origin
  /// without one; negative: earlier. Beyond the limit and what clocks may be off.
  Nanoseconds beyond(std::size_t i, std::optional<std::size_t> base, Nanoseconds& late) const {
    const double rate = base ? 1 : clockRate(knotsOf(first_.events, new_));
    const auto since = [&](const Moments& moments, const SessionTrack& track) {
      return *moments[i] - (base ? *moments[*base] : track.origin);
    };
    Nanoseconds least = Nanoseconds::max();
    Nanoseconds most = Nanoseconds::min();
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      if (!moments_[k][i] || (base && !moments_[k][*base])) continue;
      const Nanoseconds its = since(moments_[k], *accepted_[k]);
      least = std::min(least, its);
      most = std::max(most, its);
    }
    const Nanoseconds measured = since(new_, run_);
    const Nanoseconds its(std::llround(static_cast<double>(measured.count()) / rate));
    const RunLimits limits = spec_.limitsOf(itemOf(first_.events[i]));
    const Nanoseconds allowed(std::llround(
        limits.event_ms * 1e6 + std::abs(static_cast<double>(its.count())) * kClockPpm * 1e-6));
    late = its > most ? its - most : its < least ? its - least : Nanoseconds(0);
    return late > allowed ? late - allowed : late < -allowed ? late + allowed : Nanoseconds(0);
  }

  void judgeTimes() {
    std::optional<std::size_t> previous, good;
    for (std::size_t i = 0; i < first_.events.size(); ++i) {
      if (!new_[i]) continue;
      Nanoseconds late{0};
      if (spec_.align == RunAlign::origin) {
        if (beyond(i, {}, late) != Nanoseconds(0)) addLate(i, late, {});
        continue;
      }
      if (previous) {
        const Nanoseconds by = beyond(i, previous, late);
        Nanoseconds late_by_good = late;
        const bool is_good = by == Nanoseconds(0);
        const bool is_good_by_other =
            !is_good && good && good != previous && beyond(i, good, late_by_good) == Nanoseconds(0);
        // Only the one before was late: it is no knot.
        if (is_good_by_other) isolated_[*previous] = true;
        if (!is_good && !is_good_by_other) {
          addLate(i, late, previous);
        } else {
          good = i;
        }
      } else {
        good = i;
      }
      previous = i;
    }
  }

  void addLate(std::size_t i, Nanoseconds late, std::optional<std::size_t> since) {
    const Event& event = first_.events[i];
    RunFinding finding = findingAt(event, event.time, *new_[i]);
    finding.unit = "ms";
    finding.largest = std::abs(secondsOf(late)) * 1e3;
    finding.limit = spec_.limitsOf(finding.item).event_ms;
    const std::string by = since ? fmt::format(" after \"{}\"", first_.events[*since].text) : "";
    finding.what =
        fmt::format("event \"{}\" of {} is {} {}{}: at {} (accepted {})", event.text, event.source,
                    figureText(*finding.largest, "ms"), late < Nanoseconds(0) ? "early" : "late",
                    by, timeText(finding.first_run), timeText(finding.first_accepted));
    // The delay began after the event before, and so does everything that it moves.
    if (since) finding.sorts_at = first_.events[*since].time - first_.origin;
    add(std::move(finding));
  }

  /// The event where the run has it in another order.
  const Event* nearest(const Event& event, LogTime expected) const {
    const Event* found = nullptr;
    for (const Event& other : found_.run.only_b) {
      if (other.text != event.text || other.source != event.source) continue;
      if (std::ranges::find(reported_, &other) != reported_.end()) continue;
      if (found == nullptr ||
          std::chrono::abs(other.time - expected) < std::chrono::abs(found->time - expected)) {
        found = &other;
      }
    }
    return found;
  }

  /// What its source says before and after an event.
  static std::pair<std::string_view, std::string_view> besides(const std::vector<Event>& events,
                                                               const Event& event) {
    std::pair<std::string_view, std::string_view> texts;
    bool is_past = false;
    for (const Event& other : events) {
      if (other.source != event.source) continue;
      if (is_past) {
        texts.second = other.text;
        break;
      }
      is_past = other.time == event.time && other.text == event.text;
      if (!is_past) texts.first = other.text;
    }
    return texts;
  }

  /// Whether it comes within `event_ms` of where it is expected, in its source's order: then only
  /// events of other sources changed places with it, and which is heard first nobody can say.
  bool isSoon(const Event& event, const Event& moved, LogTime expected) const {
    const Nanoseconds limit(std::llround(spec_.limitsOf(itemOf(moved)).event_ms * 1e6));
    return std::chrono::abs(moved.time - expected) <= limit &&
           besides(first_.events, event) == besides(run_.events, moved);
  }

  void judgeMissing() {
    for (std::size_t i = 0; i < first_.events.size(); ++i) {
      const bool is_common =
          std::ranges::all_of(moments_, [&](const Moments& its) { return its[i].has_value(); });
      if (new_[i] || !is_common) continue;
      const Event& event = first_.events[i];
      const LogTime expected = found_.run_map.inRun(event.time);
      RunFinding finding = findingAt(event, event.time, expected);
      const Event* const moved = nearest(event, expected);
      if (moved != nullptr && isSoon(event, *moved, expected)) {
        reported_.push_back(moved);
        continue;
      }
      if (moved != nullptr) {
        finding.first_run = finding.at_run = moved->time - run_.origin;
        finding.what = fmt::format("event \"{}\" of {} is out of order: at {} (accepted {})",
                                   event.text, event.source, timeText(finding.first_run),
                                   timeText(finding.first_accepted));
        reported_.push_back(moved);
      } else {
        // Before the log begins nothing is known.
        if (expected < run_.start) continue;
        finding.what = fmt::format("event \"{}\" of {} is missing: expected at {} (accepted {})",
                                   event.text, event.source, timeText(finding.first_run),
                                   timeText(finding.first_accepted));
      }
      add(std::move(finding));
    }
  }

  void judgeExtra() {
    for (const Event& event : found_.run.only_b) {
      if (std::ranges::find(reported_, &event) != reported_.end()) continue;
      const bool is_accepted =
          std::ranges::any_of(found_.accepted, [&](const EventAlignment& alignment) {
            return std::ranges::any_of(alignment.only_b, [&](const Event& other) {
              return other.text == event.text && other.source == event.source;
            });
          });
      const LogTime in_accepted = found_.run_map.inAccepted(event.time);
      // Before the accepted log begins nothing is known.
      if (is_accepted || in_accepted < first_.start) continue;
      RunFinding finding = findingAt(event, in_accepted, event.time);
      finding.what =
          fmt::format("event \"{}\" of {} was never accepted: at {} (accepted {})", event.text,
                      event.source, timeText(finding.first_run), timeText(finding.first_accepted));
      add(std::move(finding));
    }
  }

  RunFinding findingAt(const Event& event, LogTime accepted, LogTime run) const {
    RunFinding finding;
    finding.kind = RunFinding::Kind::event;
    finding.item = itemOf(event);
    finding.first_accepted = finding.at_accepted = finding.until_accepted =
        accepted - first_.origin;
    finding.first_run = finding.at_run = run - run_.origin;
    return finding;
  }
  void add(RunFinding finding) {
    if (spec_.isMasked(finding.item, finding.first_accepted)) return;
    found_.findings.push_back(std::move(finding));
  }

  const RunSpec& spec_;
  const std::vector<const SessionTrack*>& accepted_;
  const SessionTrack& first_;
  const SessionTrack& run_;
  RunEvents& found_;
  std::vector<Moments> moments_;  ///< by accepted session
  Moments new_;
  std::vector<bool> isolated_;
  std::vector<const Event*> reported_;
};

}  // namespace

RunEvents judgeEvents(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                      const SessionTrack& run) {
  RunEvents found;
  EventJudge(spec, accepted, run, found).judge();
  return found;
}

}  // namespace rocinante
