#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/report_output.h"

namespace rocinante {

/// Arguments of `rocinante golden report` (docs/programs/golden.md).
struct ReportArguments {
  std::vector<std::filesystem::path> folders;
  ReportFiles files;
};

/// Adds the sub-command `report` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addReportCommand(CLI::App& app, ReportArguments& arguments);

/// Merges the reports of shards; the exit code is that of a single run.
Result<cli::Exit> runReportCommand(const ReportArguments& arguments);

}  // namespace rocinante
