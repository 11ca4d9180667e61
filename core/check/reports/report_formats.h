#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/check/rules/check_report.h"

namespace rocinante {

/// The layout of a text report.
struct TextStyle {
  bool color = false;
  bool unicode = false;          ///< block characters in time strips; else ASCII
  std::size_t columns = 0;       ///< lines are broken at this width; 0: never
  std::size_t most_a_rule = 10;  ///< findings shown per rule and severity; 0: all
  bool quiet = false;            ///< counts and verdict alone
};

/// Text: grouped by severity, then by subject. Ends with the verdict.
std::string checkText(const CheckReport& report, const TextStyle& style = {});
/// One JSON object that starts with "format": 1.
std::string checkJson(const CheckReport& report);
/// JUnit XML, as Jenkins and GitLab read it: every rule is a test case.
std::string checkJunit(const CheckReport& report);
/// SARIF 2.1.0. `pages`: the URL of docs/rules; empty: none.
std::string checkSarif(const CheckReport& report, const std::string& pages = {});
/// Workflow commands of GitHub Actions, one line per finding, and the verdict.
std::string checkGithub(const CheckReport& report, std::size_t most_a_rule = 10);

/// A line of a log that GitHub Actions shows beside a file's line.
struct GithubCommand {
  std::string_view level;  ///< "error", "warning" or "notice"
  std::string_view file;   ///< empty: none
  int line = 0, column = 0;
  std::string_view title, text;
};
/// "::error file=suite.toml,line=12,title=golden.different::...", with its line's end.
std::string githubCommand(const GithubCommand& command);
/// A path as a URI reference (RFC 3986): relative as it was written, absolute ones by file:.
std::string uriOf(std::string_view path);

/// The conclusion as text: "incompatible", or a message when there is no verdict.
std::string verdictText(CheckVerdict verdict);
/// "3 times, first at 1.2 s (packet 7), last at 9 s"; empty for model faults.
std::string whenText(const CheckReport& report, const Finding& finding);

}  // namespace rocinante
