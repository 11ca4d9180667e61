#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/suite_arguments.h"
#include "golden/report/report.h"

namespace rocinante {

/// Output files of a report; empty ones are not written.
struct ReportFiles {
  std::string folder;     ///< for index.html, report.json and pictures
  std::string junit;      ///< a file
  std::string json_file;  ///< a file, or `-` for standard output
  std::string sarif{};    ///< a file
  std::string summary{};  ///< a file that Markdown is appended to
  bool github = false;    ///< annotations on standard output
};

/// Adds --report, --junit, --json, --sarif, --summary and --github to a subcommand; parsing fills
/// `files`, which must outlive it.
void addReportFiles(cli::CommandLine command, ReportFiles& files);

Status writeReportFiles(const SuiteReport& report, const ReportFiles& files);

/// Prints the notes and the number of frames by verdict.
void printReportSummary(const SuiteReport& report);

/// Pages of the sessions of what is not fine (docs/programs/page.md), and the links of its frames
/// and runs to their moments. A page that cannot be made is a note of the report: no verdict
/// depends on one. not_found without the viewer that pages are made of.
Status addSessionPages(const SuiteSession& session, const SuiteArguments& arguments,
                       const std::filesystem::path& viewer, SuiteReport& report);

}  // namespace rocinante
