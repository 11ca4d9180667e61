#include "golden/report_output.h"

#include <fmt/format.h>

#include <iostream>

#include "core/atomic_file.h"

namespace rocinante {

Status writeReportFiles(const SuiteReport& report, const ReportFiles& files) {
  if (!files.junit.empty()) {
    if (auto written = writeFileWhole(files.junit, bytesOf(reportJunit(report)), true); !written) {
      return written;
    }
  }
  if (files.json_file == "-") {
    std::cout << reportJson(report);
  } else if (!files.json_file.empty()) {
    if (auto written = writeFileWhole(files.json_file, bytesOf(reportJson(report)), true);
        !written) {
      return written;
    }
  }
  if (files.folder.empty()) return {};
  if (auto written = writeReport(report, files.folder); !written) return written;
  // What `report` puts reports together from.
  return writeFileWhole(std::filesystem::path(files.folder) / "report.json",
                        bytesOf(reportJson(report)), true);
}

void printReportSummary(const SuiteReport& report) {
  for (const std::string& note : report.notes) fmt::print("note: {}\n", note);
  fmt::print("{} frames: {} same, {} different, {} missing, {} unstable, {} incomparable",
             report.frames.size(), report.count(FrameVerdict::same),
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
