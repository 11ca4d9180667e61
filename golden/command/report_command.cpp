#include <fmt/format.h>

#include <algorithm>

#include "golden/command/commands.h"
#include "golden/command/compare_command.h"
#include "golden/command/report_output.h"
#include "golden/report/report_reader.h"

namespace rocinante {

cli::CommandLine addReportCommand(cli::CommandLine app, ReportArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand("report", "merge the reports of shards");
  command.addOption("DIR", arguments.folders, "folders written by `run --report DIR`").required();
  addReportFiles(command, arguments.files);
  return command;
}

Result<cli::Exit> runReportCommand(const ReportArguments& arguments) {
  std::vector<SuiteReport> parts;
  for (const std::filesystem::path& folder : arguments.folders) {
    std::error_code ignored;
    if (!arguments.files.folder.empty() &&
        std::filesystem::equivalent(folder, arguments.files.folder, ignored)) {
      return Error{ErrorKind::bad_argument, "--report must not be an input folder",
                   arguments.files.folder};
    }
    auto part = readReport(folder);
    if (!part.ok()) return part.error();
    parts.push_back(std::move(*part));
  }
  const auto merged = mergeReports(std::move(parts));
  if (!merged.ok()) return merged.error();
  if (auto written = writeReportFiles(*merged, arguments.files); !written) {
    return written.error();
  }
  if (arguments.files.json_file != "-") {
    printReportSummary(*merged);
    if (!arguments.files.folder.empty())
      fmt::print("report: {}/index.html\n", arguments.files.folder);
  }
  return exitOf(merged->verdict());
}

}  // namespace rocinante
