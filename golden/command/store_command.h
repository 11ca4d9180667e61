#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace rocinante {

/// Arguments of `rocinante golden push` (docs/programs/golden.md).
struct PushArguments {
  std::vector<std::filesystem::path> suites;
};
/// Arguments of `rocinante golden gc`.
struct GcArguments {
  std::filesystem::path suite;
  int keep_days = 14;
  bool dry_run = false;
};

/// Adds the sub-command to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addPushCommand(CLI::App& app, PushArguments& arguments);
CLI::App* addGcCommand(CLI::App& app, GcArguments& arguments);

/// Puts what the suites' manifests name into the ref of their store.
Result<cli::Exit> runPushCommand(const PushArguments& arguments);
/// Removes from the ref of a suite's store what no branch names.
Result<cli::Exit> runGcCommand(const GcArguments& arguments);

}  // namespace rocinante
