#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace rocinante {

/// Arguments of `rocinante golden add` (docs/programs/golden.md).
struct AddArguments {
  std::filesystem::path suite;
  std::string name, at, event, after, events, every, size, tolerance, expect, reason;
  std::string cell, log;  ///< of a new suite, or the same as the suite's
  int occurrence = 0, samples = 0;
  std::vector<std::string> cameras, layers, hide, show, mask, tags, style;
};

/// Adds the sub-command `add` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addCaseCommand(CLI::App& app, AddArguments& arguments);

/// Appends the case to the suite's file; does not draw or approve.
Result<cli::Exit> runAddCommand(const AddArguments& arguments);

}  // namespace rocinante
