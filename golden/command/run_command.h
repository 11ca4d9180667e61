#pragma once

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/report_output.h"
#include "golden/command/suite_arguments.h"

namespace rocinante {

/// Arguments of `rocinante golden run` (docs/programs/golden.md).
struct RunArguments {
  SuiteArguments suite;
  ReportFiles files;
  bool verbose = false;          ///< links, figures and maps of each frame
  bool pages = false;            ///< of the sessions, beside the report
  std::filesystem::path viewer;  ///< folder of what they are made of; empty: the installed one
  int jobs = 1;                  ///< 0: by the number of frames and processors
};

/// Adds the sub-command `run` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addRunCommand(CLI::App& app, RunArguments& arguments);

/// Draws every frame, judges it, writes the reports and prints the verdicts.
Result<cli::Exit> runSuiteCommand(const RunArguments& arguments);

}  // namespace rocinante
