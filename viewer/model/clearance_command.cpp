#include <fmt/format.h>

#include "viewer/model/commands.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

struct ClearanceOptions {
  ModelFileOptions file;
  PoseOptions pose;
  bool json = false;
};

Result<cli::Exit> runClearance(const ClearanceOptions& options) {
  const Result<PoseRequest> request = poseRequestOf(options.pose, options.file.device);
  if (!request) return request.error();
  Result<Cell> cell = loadFile(options.file, true);
  if (!cell) return cell.error();
  warnOfFaults(*cell);
  StateDamage damage;
  const Result<PoseClearance> measured = poseClearance(*cell, *request, &damage);
  if (!measured) return measured.error();
  std::vector<std::string> warnings = measured->warnings;
  if (!damage.empty()) {
    warnings.push_back(damage.what() + "; links may have stale poses (" + damage.where() + ")");
  }
  const std::string text =
      options.json ? poseClearanceJson(*measured, warnings) : poseClearanceText(*measured);
  if (Status written = toStandardOutput(text); !written) return written.error();
  for (const std::string& warning : warnings) cli::warn(warning);
  return measured->areKept() && warnings.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addClearanceCommand(cli::CommandLine program) {
  auto options = std::make_shared<ClearanceOptions>();
  const cli::CommandLine app = program.addSubcommand(
      "clearance", "measure the least distances between devices and links in one pose");
  addFileOptions(app, options->file);
  addPoseOptions(app, options->pose);
  app.addFlag("--json", options->json, "print JSON");
  return {app, [options] { return runClearance(*options); }};
}

}  // namespace rocinante
