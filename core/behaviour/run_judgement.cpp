#include "core/behaviour/run_judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace rocinante {

bool RunFinding::operator<(const RunFinding& other) const {
  // Causes before effects: what changed in the model, and what is not judged, have no time.
  const auto place = [](const RunFinding& its) {
    return std::tuple(std::min(its.kind, Kind::event), its.sorts_at, its.kind,
                      std::string_view(its.item), std::string_view(its.unit));
  };
  return place(*this) < place(other);
}

double severityOf(const RunFinding& finding) {
  if (!finding.largest) return std::numeric_limits<double>::infinity();
  return *finding.largest / std::max(finding.limit, 1e-9);
}

std::vector<RunSpan> joined(std::vector<RunSpan> spans, Nanoseconds reach) {
  std::ranges::sort(spans, {}, &RunSpan::from);
  std::vector<RunSpan> all;
  for (const RunSpan& span : spans) {
    if (all.empty() || span.from - all.back().until > reach) {
      all.push_back(span);
    } else {
      all.back().until = std::max(all.back().until, span.until);
    }
  }
  return all;
}

std::string_view nameOf(RunFinding::Kind kind) {
  switch (kind) {
    case RunFinding::Kind::model:
      return "model";
    case RunFinding::Kind::coverage:
      return "coverage";
    case RunFinding::Kind::event:
      return "event";
    case RunFinding::Kind::rate:
      return "rate";
    case RunFinding::Kind::joint:
      return "joint";
    case RunFinding::Kind::pose:
      return "pose";
    case RunFinding::Kind::signal:
      return "signal";
    case RunFinding::Kind::fact:
      return "fact";
    case RunFinding::Kind::drawing:
      return "drawing";
  }
  return "fact";
}

std::string figureText(double figure, std::string_view unit) {
  // Of motions nothing is so small or large; of signals anything is.
  if (unit != "ms" && figure != 0 && (figure < 0.00995 || figure >= 1e7)) {
    return fmt::format("{:.3g}{}{}", figure, unit.empty() || unit == "°" ? "" : " ", unit);
  }
  const int digits = unit == "ms" || figure >= 99.95 ? 0
                     : figure >= 9.995               ? 1
                     : figure >= 0.0995              ? 2
                                                     : 3;
  return fmt::format("{:.{}f}{}{}", figure, digits,
                     unit.empty() || unit == "°" || unit == "/s" ? "" : " ", unit);
}

}  // namespace rocinante
