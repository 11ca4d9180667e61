#include "golden/run/run_judgement.h"

#include <fmt/format.h>

#include <tuple>

namespace rocinante {

bool RunFinding::operator<(const RunFinding& other) const {
  return std::tie(first_accepted, kind, item, unit) <
         std::tie(other.first_accepted, other.kind, other.item, other.unit);
}

std::string_view nameOf(RunFinding::Kind kind) {
  switch (kind) {
    case RunFinding::Kind::event:
      return "event";
    case RunFinding::Kind::rate:
      return "rate";
    case RunFinding::Kind::joint:
      return "joint";
    case RunFinding::Kind::pose:
      return "pose";
    case RunFinding::Kind::fact:
      return "fact";
    case RunFinding::Kind::drawing:
      return "drawing";
  }
  return "fact";
}

std::string figureText(double figure, std::string_view unit) {
  const int digits = unit == "ms" || figure >= 99.95 ? 0
                     : figure >= 9.995               ? 1
                     : figure >= 0.0995              ? 2
                                                     : 3;
  return fmt::format("{:.{}f}{}{}", figure, digits, unit == "°" || unit == "/s" ? "" : " ", unit);
}

}  // namespace rocinante
