#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/report_output.h"

namespace rocinante {

/// What `rocinante golden report` was asked for (docs/programs/golden.md).
struct ReportArguments {
  std::vector<std::filesystem::path> folders;
  ReportFiles files;
};

/// Adds the sub-command `report` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addReportCommand(CLI::App& app, ReportArguments& arguments);

/// Puts the reports of shards together; the exit code is what one run would have answered.
Result<cli::Exit> runReportCommand(const ReportArguments& arguments);

}  // namespace rocinante
