#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/check/rules/rule_settings.h"
#include "core/report/finding.h"

namespace rocinante {

/// Which rules have nothing to judge in this cell, without or with a session, and why: as
/// CheckReport::unjudged.
std::map<std::string, std::string, std::less<>> unjudgedRules(const Cell& cell, bool has_session);

enum class CheckVerdict : std::uint8_t {
  compatible,
  incompatible,    ///< a finding of severity `fail_on` or above
  nothing_judged,  ///< no packet could be decoded: never the same as compatible
  interrupted,     ///< stopped before the end: the findings are valid but not complete
};
std::string_view nameOf(CheckVerdict verdict);

/// How near two devices (or one and itself) came, for one `[[clearance]]` of the cell.
struct CheckedClearance {
  std::string name;  ///< of the clearance
  std::string device_a, device_b;
  double min_m = 0;
  double least_m = 0;                    ///< 0: they penetrate each other
  std::string link_a, link_b;            ///< the nearest: "DEVICE/LINK"
  std::array<double, 3> on_a{}, on_b{};  ///< the nearest points, in the world
  LogTime at{};
  std::uint64_t violations = 0;  ///< spans in which they were nearer than `min_m`
  struct Span {
    LogTime from{}, until{};
    double least_m = 0;
  };
  std::vector<Span> spans;  ///< the first 100
};

/// The result of `check`.
struct CheckReport {
  std::string cell;     ///< as the user named it
  std::string session;  ///< log or endpoint; empty when the model alone was judged
  bool has_session = false;
  bool has_cell = true;  ///< false: `cell` is empty, and what needs one is not judged
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;  ///< of those, decoded
  /// Live, where senders must sign: datagrams refused, by reason, and not judged. Otherwise empty.
  std::vector<std::pair<std::string, std::uint64_t>> untrusted;
  std::vector<std::string> sources;
  LogTime origin{};
  Nanoseconds duration{0};
  Findings findings;                         ///< errors first, then by first time, then by rule
  std::vector<CheckedClearance> clearances;  ///< as the cell has them, then by device
  RuleSettings rules;  ///< the rules as the cell sets them; conclude() applies them
  /// Why the rules with this first part ("urdf", "joint"), or of this id, had nothing to judge.
  std::map<std::string, std::string, std::less<>> unjudged;
  bool has_baseline = false;
  bool interrupted = false;
  Severity fail_on = Severity::error;  ///< a finding this severe makes it incompatible
  CheckVerdict verdict = CheckVerdict::nothing_judged;

  /// Findings that no baseline accepts.
  std::size_t countOf(Severity severity) const;
  std::size_t countOfAccepted() const;
  bool isFailure(const Finding& finding) const {
    return !finding.accepted && finding.severity >= fail_on;
  }
};

/// Sets the severities of the findings, removes those of rules that are off, sorts them and
/// computes the verdict. May be called again.
void conclude(CheckReport& report);

}  // namespace rocinante
