#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/report/time_histogram.h"

namespace rocinante {

enum class Severity : std::uint8_t { note, warning, error };
std::string_view nameOf(Severity severity);

/// One thing that is wrong, or worth knowing, about a file, a session or live traffic. Readers of
/// files go on after it: all findings are listed. docs/rules explains the rules of models, cells
/// and sessions, docs/programs/log.md those of logs.
struct Finding {
  std::string rule{};  ///< stable id: "packet.unknown-device"
  Severity severity = Severity::error;
  std::string text{};  ///< one sentence
  std::string hint{};  ///< what to do about it; may be empty
  /// What was given and not used, "element `pbr`", when the finding states that: then it is part of
  /// the file's account. Else empty.
  std::string left_out{};

  std::string file{};                   ///< empty: of a session, or of the one file examined
  int line = 0, column = 0;             ///< in `file`, from 1; 0: none
  std::optional<std::uint64_t> byte{};  ///< in a binary file, from 0

  std::uint64_t count = 1;
  std::optional<LogTime> first{}, last{};  ///< of a session's findings
  TimeHistogram when{};                    ///< may hold fewer than `count`
  std::optional<std::uint64_t> packet{};   ///< of the first: captured datagrams of the log from 1
  std::string subject{};                   ///< device, source or endpoint; may be empty
  std::string example{};  ///< the first offending line of packet text; may be empty
  /// How bad it is, where the sentence states an angle, a distance or a speed: larger is worse, in
  /// the unit of the sentence and as rounded there. Never a count or a time.
  std::optional<double> worst{};
  bool accepted = false;  ///< by a baseline: shown, but not a reason to fail

  /// "cell.toml:12:3", as compilers write it; empty without a file.
  std::string place() const;
  /// "cell.toml:12:3: error: unknown key `colour` (did you mean `color`?) [cell.unknown-key]"
  std::string print() const;
};

using Findings = std::vector<Finding>;

/// Null when no finding is an error.
const Finding* firstError(const Findings& findings);
std::size_t countOf(const Findings& findings, Severity severity);

}  // namespace rocinante
