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

/// A subcommand of `rocinante model`: its options and action. Each lies in its own
/// NAME_command.cpp (docs/programs/model.md).
struct ModelCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};
ModelCommand addInfoCommand(CLI::App& program);
ModelCommand addTreeCommand(CLI::App& program);
ModelCommand addFkCommand(CLI::App& program);
ModelCommand addClearanceCommand(CLI::App& program);
ModelCommand addConvertCommand(CLI::App& program);

/// The file of a subcommand and how to load it.
struct ModelFileOptions : ModelSearch {
  std::string file;
  bool strict = false;
  std::string device;  ///< empty: all of a cell
};
void addFileOptions(CLI::App& app, ModelFileOptions& options);
/// Loads it, with or without the meshes. `device` must be one of the cell's.
Result<Cell> loadFile(const ModelFileOptions& options, bool geometry);

/// Joint values and poses from the command line.
struct PoseOptions {
  std::string positions;
  std::vector<std::string> named;
  std::string base;
  std::string log, at, event;
  bool degrees = false;
};
void addPoseOptions(CLI::App& app, PoseOptions& options);
Result<PoseRequest> poseRequestOf(const PoseOptions& options, const std::string& device);

/// Prints errors and warnings of the cell on standard error, one per line; notes only appear in
/// `info`.
void warnOfFaults(const Cell& cell);

/// Writes all of `text` to standard output or returns an error.
Status toStandardOutput(std::string_view text);

}  // namespace rocinante
