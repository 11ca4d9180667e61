#include "golden/report_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "golden/compare_command.h"
#include "golden/merged_report.h"
#include "golden/report_output.h"

namespace rocinante {

CLI::App* addReportCommand(CLI::App& app, ReportArguments& arguments) {
  CLI::App* command = app.add_subcommand("report", "put the reports of shards together");
  command->add_option("DIR", arguments.folders, "what `run --report DIR` wrote; several")
      ->required();
  command->add_option("--report", arguments.report, "folder for index.html and the pictures");
  command->add_option("--junit", arguments.junit, "write JUnit XML");
  command
      ->add_option("--json", arguments.json_file,
                   "write the verdicts as JSON; - is standard output")
      ->expected(0, 1)
      ->default_str("-");
  return command;
}

Result<cli::Exit> runReportCommand(const ReportArguments& arguments) {
  std::vector<SuiteReport> parts;
  for (const std::filesystem::path& folder : arguments.folders) {
    std::error_code ignored;
    if (!arguments.report.empty() &&
        std::filesystem::equivalent(folder, arguments.report, ignored)) {
      return Error{ErrorKind::bad_argument, "the whole cannot lie where a part lies",
                   arguments.report};
    }
    auto part = readReport(folder);
    if (!part.ok()) return part.error();
    parts.push_back(std::move(*part));
  }
  const auto merged = mergeReports(std::move(parts));
  if (!merged.ok()) return merged.error();
  if (auto written =
          writeReportFiles(*merged, {arguments.report, arguments.junit, arguments.json_file});
      !written) {
    return written.error();
  }
  if (arguments.json_file != "-") {
    printReportSummary(*merged);
    if (!arguments.report.empty()) fmt::print("report: {}/index.html\n", arguments.report);
  }
  return exitOf(merged->verdict());
}

}  // namespace rocinante
