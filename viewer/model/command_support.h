#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cli/program.h"
#include "viewer/model/pose_request.h"

namespace CLI {
class App;
}

namespace rocinante {

/// A subcommand of `rocinante model`: options, and what is done when it was given.
struct ModelCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};

/// The file that every subcommand looks at, and how.
struct ModelFileOptions : ModelSearch {
  std::string file;
  bool strict = false;
  std::string device;  ///< empty: all of a cell
};
void addFileOptions(CLI::App& app, ModelFileOptions& options);
/// Loads it, with or without the meshes. `device` must be one of the cell's.
Result<Cell> loadFile(const ModelFileOptions& options, bool geometry);

/// Where its joints stand, as people write it.
struct PoseOptions {
  std::string positions;
  std::vector<std::string> named;
  std::string base;
  std::string log, at;
  bool degrees = false;
};
void addPoseOptions(CLI::App& app, PoseOptions& options);
Result<PoseRequest> poseRequestOf(const PoseOptions& options, const std::string& device);

/// Errors and warnings of the cell on standard error, a line each; notes are for `info`.
void warnOfFaults(const Cell& cell);

/// All of `text` goes to standard output, or it is an error.
Status toStandardOutput(std::string_view text);

}  // namespace rocinante
