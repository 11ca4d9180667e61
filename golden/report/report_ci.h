#pragma once

#include <string>

#include "golden/report/report.h"

namespace rocinante {

/// SARIF 2.1.0: a result for each frame that is not fine, at its case's line of the suite.
std::string reportSarif(const SuiteReport& report);
/// Workflow commands of GitHub Actions, a line for each frame that is not fine.
std::string reportGithub(const SuiteReport& report);

}  // namespace rocinante
