#pragma once

#include <string>

#include "golden/report/report.h"

namespace rocinante {

/// SARIF 2.1.0: one result per frame that is not fine, at its case's line in the suite.
std::string reportSarif(const SuiteReport& report);
/// Workflow commands of GitHub Actions, one line per frame that is not fine.
std::string reportGithub(const SuiteReport& report);

}  // namespace rocinante
