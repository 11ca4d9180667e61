#pragma once

#include <string>

#include "golden/report/report.h"

namespace rocinante {

/// SARIF 2.1.0: one result per frame that is not fine, at its case's line in the suite.
std::string reportSarif(const SuiteReport& report);
/// Workflow commands of GitHub Actions, one line per frame that is not fine.
std::string reportGithub(const SuiteReport& report);
/// Markdown for the page of a job ($GITHUB_STEP_SUMMARY, a comment in GitLab): the counts, a row
/// for each frame that is not fine with the reasons below it, and how to repeat and accept. `page`
/// is the path of the report's index.html, or empty.
std::string reportMarkdown(const SuiteReport& report, const std::string& page);

}  // namespace rocinante
