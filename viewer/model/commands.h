#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cli/program.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

// The subcommands of `rocinante model`, added to the program. Each lies in its own NAME_command.cpp
// (docs/programs/model.md).
cli::Subcommand addInfoCommand(cli::CommandLine program);
cli::Subcommand addTreeCommand(cli::CommandLine program);
cli::Subcommand addFkCommand(cli::CommandLine program);
cli::Subcommand addClearanceCommand(cli::CommandLine program);
cli::Subcommand addConvertCommand(cli::CommandLine program);

/// The file of a subcommand and how to load it.
struct ModelFileOptions : ModelSearch {
  std::string file;
  bool strict = false;
  std::string device;  ///< empty: all of a cell
};
void addFileOptions(cli::CommandLine app, ModelFileOptions& options);
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
void addPoseOptions(cli::CommandLine app, PoseOptions& options);
Result<PoseRequest> poseRequestOf(const PoseOptions& options, const std::string& device);

/// Prints errors and warnings of the cell on standard error, one per line; notes only appear in
/// `info`.
void warnOfFaults(const Cell& cell);

/// Writes all of `text` to standard output or returns an error.
Status toStandardOutput(std::string_view text);

}  // namespace rocinante
