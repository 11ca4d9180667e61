#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/run/run_spec.h"

namespace rocinante {

/// Arguments of `rocinante golden session` (docs/programs/golden.md).
struct SessionArguments : ModelSearch {
  std::filesystem::path a, b, cell;
  std::vector<std::string> more_accepted;
  std::string camera, tier = "loose", size = "640x480", report, align = "events";
  RunLimits limits;
  bool no_pictures = false, json = false;
};

CLI::App* addSessionCommand(CLI::App& app, SessionArguments& arguments);
Result<cli::Exit> runSessionCommand(const SessionArguments& arguments);

}  // namespace rocinante
