#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Writes folder/index.html, report.json, page-pictures.json and, for each frame that is not fine,
/// NAME.frame.png, NAME.golden.png and NAME.difference.png, and of all of them differences.png
/// (DifferenceSheet); for each run that is different, NAME.run-1.png and so on. Creates the folder.
/// All files are written aside first: on an error the old report stays intact. Pictures of the old
/// report that the new one does not have are removed.
Status writeReport(const SuiteReport& report, const std::filesystem::path& folder);

/// One self-contained page: no network, pictures inside. docs/golden-report.md.
std::string reportHtml(const SuiteReport& report);

/// "11 of 12 frames as accepted, 1 of 1 run as accepted".
std::string asAcceptedText(const SuiteReport& report);

/// SARIF 2.1.0: one result per frame that is not fine, at its case's line in the suite.
std::string reportSarif(const SuiteReport& report);
/// Workflow commands of GitHub Actions, one line per frame that is not fine.
std::string reportGithub(const SuiteReport& report);
/// Markdown for the page of a job ($GITHUB_STEP_SUMMARY, a comment in GitLab): the counts, a row
/// for each frame that is not fine with the reasons below it, and how to repeat and accept. `page`
/// is the path of the report's index.html, or empty.
std::string reportMarkdown(const SuiteReport& report, const std::string& page);

}  // namespace rocinante
