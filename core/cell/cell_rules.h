#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/finding.h"

namespace rocinante {

/// A threshold of a rule, named after its unit: "ms".
struct CellThreshold {
  std::string key;
  double value = 0;
};

/// One entry of a cell's `[rules]`. Only `check` knows which rules exist.
struct CellRule {
  std::string id;
  bool is_off = false;
  std::optional<Severity> severity;  ///< empty: the default, unless it is off
  std::string threshold_key;         ///< "ms"; empty: none is given
  double threshold = 0;
  std::map<std::string, CellThreshold> own_thresholds;  ///< of a DEVICE or "DEVICE/JOINT"
  std::string file;          ///< with this entry: the cell, or an included file
  int line = 0, column = 0;  ///< of the rule's id in it; 0: not from a file
};

/// "off", "note", "warning" or "error" into `rule`; false when `word` is another word.
bool readSeverity(std::string_view word, CellRule& rule);

/// What `check` expects of the packets of a source, beyond its rate. Empty: the rule's threshold.
struct SourceLimits {
  std::optional<double> silence_s;     ///< longest without a packet
  std::optional<double> restate_s;     ///< longest without a restatement
  std::optional<double> clock_skew_s;  ///< of TIME against arrival
  std::optional<double> jitter_ms;     ///< of arrival against the mean period
};

}  // namespace rocinante
