#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/reports/report_formats.h"

namespace CLI {
class App;
}

namespace rocinante {

/// The command line arguments of rocinante-check.
struct CheckArguments : ModelSearch {
  std::string cell, log, trust;
  std::vector<std::string> live;
  std::string duration = "2s";
  std::string format = "text";
  bool json = false;
  std::vector<std::string> outputs;  ///< FORMAT=FILE
  bool force = false;
  bool quiet = false;
  std::size_t most_a_rule = 10;
  std::string rule_pages;
  std::vector<std::string> rules;  ///< ID=SEVERITY
  std::string fail_on = "error";
  bool strict = false;
  std::string baseline;
  bool update_baseline = false;
  bool list_rules = false;
  std::string explain;

  bool wantsJson() const { return json || format == "json"; }
};

void declareCheck(CLI::App& app, CheckArguments& arguments);

/// The rules given by --rule; bad_argument for an unknown rule or severity.
Result<std::vector<CellRule>> readRuleArguments(const CheckArguments& arguments);
Severity failOn(const CheckArguments& arguments);

}  // namespace rocinante
