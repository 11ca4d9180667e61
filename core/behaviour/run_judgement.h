#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/behaviour/run_coverage.h"
#include "core/behaviour/time_map.h"

namespace rocinante {

/// A value over time beside the accepted band, reduced to a few hundred points.
struct RunCurve {
  std::vector<double> seconds;      ///< since the accepted origin
  std::vector<double> least, most;  ///< the accepted band, widened by the limit
  std::vector<double> value;        ///< the run's; NaN: it has none
};

/// A stretch of time, both ends included; they may be the same.
struct RunSpan {
  Nanoseconds from{0}, until{0};
  bool operator==(const RunSpan&) const = default;
};
/// In order; those that are at most `reach` apart as one.
std::vector<RunSpan> joined(std::vector<RunSpan> spans, Nanoseconds reach);

/// Something in which a run leaves what was accepted.
struct RunFinding {
  enum class Kind : std::uint8_t {
    model,
    coverage,
    event,
    rate,
    joint,
    pose,
    signal,
    fact,
    drawing
  };
  Kind kind = Kind::joint;
  std::string item;  ///< "arm/elbow", "arm", "arm/hand", "event/picked", "signal arm current"
  std::string unit;  ///< "°", "mm", "ms", "/s", a signal's; empty without one
  std::string what;  ///< one sentence, with both times
  std::optional<double> largest;  ///< beyond the accepted band
  double limit = 0;
  std::string accept;  ///< the entry of `limits`, as TOML, that accepts it; empty: none does
  /// Since the origin of each session; `first`: where it begins, `at`: where it is largest.
  Nanoseconds first_accepted{0}, first_run{0}, at_accepted{0}, at_run{0}, until_accepted{0};
  RunCurve curve;
  /// Where its item is so, since the accepted origin, joined(). Empty: from `first_accepted` until
  /// `until_accepted`. Not in reports.
  std::vector<RunSpan> spans;
  /// Causes come first: what an event's delay or a joint moves follows it. Not in reports.
  Nanoseconds sorts_at{0};

  bool operator<(const RunFinding& other) const;
};
std::string_view nameOf(RunFinding::Kind kind);
/// `largest` in limits, by which findings are compared. One without a figure, such as a missing
/// device, is larger than all that have one.
double severityOf(const RunFinding& finding);

/// The outcome of comparing a session with the accepted ones of a run.
struct RunJudgement {
  bool comparable = false;  ///< false: `rule` says why not
  std::string rule;         ///< one sentence
  /// What changed in the model, what is no longer judged, then in order of time; empty: the run is
  /// as accepted.
  std::vector<RunFinding> findings;
  std::vector<std::string> notes;
  RunCoverage coverage;
  std::size_t accepted = 0;
  std::size_t items = 0;          ///< of `coverage.judged`, but for events
  std::size_t events = 0;         ///< of the first accepted session, but for masked ones
  std::uint64_t values = 0;       ///< of packets, compared with what the other side has about then
  Nanoseconds from{0}, until{0};  ///< the judged range, since the accepted origin
  TimeMap times{};                ///< from the first accepted session to the run; not in reports
};

/// "0.52°", "3.1 mm", "50 ms".
std::string figureText(double figure, std::string_view unit);

}  // namespace rocinante
