#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/check/rules/finding.h"
#include "golden/check/check_options.h"

namespace rocinante {

/// A file that --output asks for.
struct CheckOutput {
  std::string format, file;
};

/// What --output says; bad_argument when it is not FORMAT=FILE, refused when the file exists and
/// --force was not given: before anything is judged.
Result<std::vector<CheckOutput>> readOutputs(const CheckArguments& arguments);

/// The report on standard output as --format says, and in every file, each whole or not at all.
Status writeReport(const CheckReport& report, const CheckArguments& arguments,
                   const std::vector<CheckOutput>& outputs);

/// --list-rules and --explain.
void printRules(bool as_json);
Status explainRule(const std::string& rule);

}  // namespace rocinante
