#include <fmt/format.h>

#include <map>

#include "core/base/plain_text.h"
#include "core/check/reports/report_formats.h"
#include "core/report/account.h"

namespace rocinante {
namespace {

/// The runner decodes these: https://github.com/actions/toolkit, "command.ts".
std::string escapedData(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '%':
        escaped += "%25";
        break;
      case '\r':
        escaped += "%0D";
        break;
      case '\n':
        escaped += "%0A";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string escapedProperty(std::string_view text) {
  std::string escaped;
  for (const char c : escapedData(text)) {
    if (c == ':') {
      escaped += "%3A";
    } else if (c == ',') {
      escaped += "%2C";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string_view commandOf(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "notice";
  }
  return "error";
}

std::string commandFor(const CheckReport& report, const Finding& finding) {
  std::string text = plainText(sentenceOf(finding));
  if (finding.first) text += "\n" + whenText(report, finding);
  if (!finding.example.empty()) text += "\nsuch as: " + plainText(finding.example);
  if (!finding.hint.empty()) text += "\nhint: " + plainText(finding.hint);
  return githubCommand({commandOf(finding.severity), finding.file, finding.line, finding.column,
                        finding.rule, text});
}

}  // namespace

std::string githubCommand(const GithubCommand& command) {
  std::string line = fmt::format("::{} ", command.level);
  if (!command.file.empty()) {
    line += fmt::format("file={},", escapedProperty(command.file));
    if (command.line > 0) line += fmt::format("line={},", command.line);
    if (command.line > 0 && command.column > 0) line += fmt::format("col={},", command.column);
  }
  return line +
         fmt::format("title={}::{}\n", escapedProperty(command.title), escapedData(command.text));
}

std::string checkGithub(const CheckReport& report, std::size_t most_a_rule) {
  std::string text;
  std::map<std::string_view, std::size_t> listed, left_out;
  for (const Finding& finding : report.findings) {
    if (finding.accepted) continue;
    if (most_a_rule > 0 && listed[finding.rule] == most_a_rule) {
      ++left_out[finding.rule];
      continue;
    }
    ++listed[finding.rule];
    text += commandFor(report, finding);
  }
  for (const auto& [rule, more] : left_out) {
    text += fmt::format("::notice title={}::and {} more\n", escapedProperty(rule), more);
  }
  if (report.verdict == CheckVerdict::nothing_judged ||
      report.verdict == CheckVerdict::interrupted) {
    text += fmt::format("::error title=rocinante check::{}\n",
                        escapedData(verdictText(report.verdict)));
  }
  return text + fmt::format("{}{}{}: {}\n", report.cell,
                            report.session.empty() || !report.has_cell ? "" : " and ",
                            report.session, verdictText(report.verdict));
}

}  // namespace rocinante
