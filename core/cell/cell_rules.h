#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/model_fault.h"

namespace rocinante {

/// What `[rules]` of a cell says of one rule of `check`. Which rules there are, `check` knows.
struct CellRule {
  std::string id;
  bool is_off = false;
  std::optional<Severity> severity;  ///< empty: as it is by default, unless it is off
  std::string threshold_key;         ///< "ms"; empty: none is given
  double threshold = 0;
  std::string file;          ///< that says so: the cell, or one that it includes
  int line = 0, column = 0;  ///< of the rule's id there; 0: not from a file
};

/// "off", "note", "warning" or "error" into `rule`; false when `word` is none of these.
bool readSeverity(std::string_view word, CellRule& rule);

/// What `check` expects of the packets of a source, beyond its rate. Empty: the rule's threshold.
struct SourceLimits {
  std::optional<double> silence_s;     ///< longest without a packet
  std::optional<double> restate_s;     ///< longest without a restatement
  std::optional<double> clock_skew_s;  ///< of TIME against arrival
  std::optional<double> jitter_ms;     ///< of arrival against the mean period
};

}  // namespace rocinante
