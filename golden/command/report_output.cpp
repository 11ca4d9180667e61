#include "golden/command/report_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "golden/report/report_formats.h"

namespace rocinante {
namespace {

Status appendToFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::app | std::ios::binary);
  file << text << std::flush;
  if (!file) return Error{ErrorKind::unreadable, "cannot append the summary", path};
  return {};
}

}  // namespace

void addReportFiles(cli::CommandLine command, ReportFiles& files) {
  command.addOption("--report", files.folder, "folder for index.html and the pictures");
  command.addOption("--junit", files.junit, "write JUnit XML");
  command.addOption("--sarif", files.sarif, "write SARIF 2.1.0, for code scanning");
  command.addOption("--summary", files.summary,
                    "append Markdown for the job's page, as to $GITHUB_STEP_SUMMARY");
  const cli::Option json =
      command
          .addOption("--json", files.json_file, "write the verdicts as JSON; - is standard output")
          .bareMeans("-");
  command.addFlag("--github", files.github, "annotate the suite file in GitHub Actions")
      .excludes(json);
}

Status writeReportFiles(const SuiteReport& report, const ReportFiles& files) {
  if (!files.junit.empty()) {
    if (auto written = writeFileWhole(files.junit, bytesOf(reportJunit(report)), true); !written) {
      return written;
    }
  }
  if (!files.sarif.empty()) {
    if (auto written = writeFileWhole(files.sarif, bytesOf(reportSarif(report)), true); !written) {
      return written;
    }
  }
  if (!files.summary.empty()) {
    const std::string page = files.folder.empty() ? "" : files.folder + "/index.html";
    if (auto written = appendToFile(files.summary, reportMarkdown(report, page)); !written) {
      return written;
    }
  }
  if (files.github) fmt::print("{}", reportGithub(report));
  if (files.json_file == "-") {
    std::cout << reportJson(report);
  } else if (!files.json_file.empty()) {
    if (auto written = writeFileWhole(files.json_file, bytesOf(reportJson(report)), true);
        !written) {
      return written;
    }
  }
  return files.folder.empty() ? Status() : writeReport(report, files.folder);
}

void printReportSummary(const SuiteReport& report) {
  for (const std::string& note : report.notes) fmt::print("note: {}\n", plainText(note));
  if (!report.runs.empty()) {
    const auto count = [&](FrameVerdict verdict) {
      return std::ranges::count(report.runs, verdict, &JudgedRun::verdict);
    };
    fmt::print("{}: {} same, {} different, {} missing, {} incomparable\n",
               countText(report.runs.size(), "run"), count(FrameVerdict::same),
               count(FrameVerdict::different), count(FrameVerdict::missing),
               count(FrameVerdict::incomparable));
    if (report.frames.empty()) return;
  }
  fmt::print("{}: {} same, {} different, {} missing, {} unstable, {} incomparable",
             countText(report.frames.size(), "frame"), report.count(FrameVerdict::same),
             report.count(FrameVerdict::different), report.count(FrameVerdict::missing),
             report.count(FrameVerdict::unstable), report.count(FrameVerdict::incomparable));
  for (const FrameVerdict verdict : {FrameVerdict::expected, FrameVerdict::unexpected}) {
    if (const std::size_t count = report.count(verdict); count > 0) {
      fmt::print(", {} {}", count, nameOf(verdict));
    }
  }
  fmt::print("\n");
}

}  // namespace rocinante
