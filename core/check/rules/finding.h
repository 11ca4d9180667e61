#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/check/rules/rule_settings.h"
#include "core/check/rules/time_histogram.h"
#include "core/document/model_fault.h"

namespace rocinante {

/// One thing that is wrong, or worth knowing, about a cell or a session: docs/programs/check.md
/// explains every rule.
struct Finding {
  std::string rule;  ///< stable id: "packet.unknown-device"
  Severity severity = Severity::error;
  std::uint64_t count = 1;
  std::optional<LogTime> first, last;   ///< empty for model faults
  TimeHistogram when;                   ///< of the session's findings; may hold fewer than `count`
  std::optional<std::uint64_t> packet;  ///< of the first: captured datagrams of the log from 1
  std::string subject;                  ///< device, source or endpoint; may be empty
  std::string text;                     ///< one sentence
  std::string example;                  ///< the first offending line of packet text; may be empty
  std::string hint;                     ///< what to do about it; may be empty
  std::string file;                     ///< of a model fault
  int line = 0, column = 0;             ///< in `file`; 0: none
  bool accepted = false;                ///< by a baseline: shown, but not a reason to fail
};

enum class CheckVerdict : std::uint8_t {
  compatible,
  incompatible,    ///< a finding of severity `fail_on` or above
  nothing_judged,  ///< no packet could be decoded: never the same as compatible
  interrupted,     ///< stopped before the end: the findings are valid but not complete
};
std::string_view nameOf(CheckVerdict verdict);

/// The result of `check`.
struct CheckReport {
  std::string cell;     ///< as the user named it
  std::string session;  ///< log or endpoint; empty when the model alone was judged
  bool has_session = false;
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;  ///< of those, decoded
  std::vector<std::string> sources;
  LogTime origin{};
  Nanoseconds duration{0};
  std::vector<Finding> findings;  ///< errors first, then by first time, then by rule
  RuleSettings rules;             ///< the rules as the cell sets them; conclude() applies them
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
