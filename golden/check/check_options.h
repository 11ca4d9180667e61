#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/reports/report_formats.h"
#include "core/cli/command_line.h"
#include "golden/check/check_watch.h"

namespace rocinante {

/// The command line arguments of rocinante-check.
struct CheckArguments : ModelSearch {
  std::string cell, log, trust, decoders;
  std::vector<std::string> live;
  std::string duration;  ///< empty: 2 s, or for ever
  bool watch = false, until_finding = false;
  std::string watch_severity = "note", hold = "5s", on_finding;
  std::string format = "text";
  bool json = false;
  std::vector<std::string> outputs;  ///< FORMAT=FILE
  bool force = false;
  bool quiet = false;
  std::size_t most_a_rule = 10;
  std::string rule_pages;
  std::vector<std::string> rules;  ///< ID=SEVERITY
  std::string preset;              ///< "ci", or empty
  std::string fail_on = "error";
  bool strict = false;
  std::string baseline;
  bool update_baseline = false;
  bool list_rules = false;
  std::string explain;

  bool printsJson() const { return json || format == "json"; }
};

void declareCheck(cli::CommandLine app, CheckArguments& arguments);

/// The rules given by --rule; bad_argument for an unknown rule or severity.
Result<std::vector<CellRule>> readRuleArguments(const CheckArguments& arguments);
Severity failOn(const CheckArguments& arguments);

/// --watch and what goes with it, but for the baseline. bad_argument for invalid values.
Result<CheckWatchOptions> readWatchArguments(const CheckArguments& arguments);
/// A duration greater than zero; the error names `option`.
Result<Nanoseconds> readPositive(const std::string& text, const char* option);

}  // namespace rocinante
