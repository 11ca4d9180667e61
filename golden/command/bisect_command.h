#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/cli/program.h"

namespace rocinante {

/// Arguments of `rocinante golden bisect` (docs/programs/golden.md).
struct BisectArguments : ModelSearch {
  std::filesystem::path log, cell;
  std::string other_log, other_cell, other_render, camera, size = "640x480", from, until;
  int samples = 4;
  std::size_t most_frames = 2000;
  bool json = false;
};

CLI::App* addBisectCommand(CLI::App& app, BisectArguments& arguments);
Result<cli::Exit> runBisectCommand(const BisectArguments& arguments);

}  // namespace rocinante
