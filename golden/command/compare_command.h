#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/compare/compare.h"

namespace rocinante {

/// Arguments of `rocinante golden compare` (docs/programs/golden.md).
struct CompareArguments {
  std::filesystem::path frame, golden;
  std::string tier = "exact";
  std::vector<std::string> masks;
  std::filesystem::path difference;  ///< empty: not written
  bool force = false, quiet = false, json = false;
};

/// Adds the sub-command `compare` to `app`; parsing fills `arguments`, which must outlive it.
cli::CommandLine addCompareCommand(cli::CommandLine app, CompareArguments& arguments);

/// Compares the two pictures and prints the answer.
Result<cli::Exit> runCompareCommand(const CompareArguments& arguments);

/// 0 same, 1 different, 2 incomparable.
cli::Exit exitOf(Verdict verdict);

}  // namespace rocinante
