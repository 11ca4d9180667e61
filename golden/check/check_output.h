#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/check/rules/check_report.h"
#include "golden/check/check_options.h"

namespace rocinante {

/// A file requested by --output.
struct CheckOutput {
  std::string format, file;
};

/// Parses --output before anything is judged. bad_argument when it is not FORMAT=FILE, refused when
/// the file exists and --force was not given.
Result<std::vector<CheckOutput>> readOutputs(const CheckArguments& arguments);

/// Writes the report to standard output in the format of --format, and to every --output file, each
/// completely or not at all.
Status writeReport(const CheckReport& report, const CheckArguments& arguments,
                   const std::vector<CheckOutput>& outputs);

/// --list-rules and --explain.
void printRules(bool as_json);
Status explainRule(const std::string& rule);

}  // namespace rocinante
