
#include "viewer/model/commands.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

struct FkOptions {
  ModelFileOptions file;
  PoseOptions pose;
  bool json = false;
};

Result<cli::Exit> runFk(const FkOptions& options) {
  const Result<PoseRequest> request = poseRequestOf(options.pose, options.file.device);
  if (!request) return request.error();
  const Result<Cell> cell = loadFile(options.file, false);
  if (!cell) return cell.error();
  warnOfFaults(*cell);
  StateDamage damage;
  const auto links = forwardKinematics(*cell, *request, &damage);
  if (!links) return links.error();
  std::vector<std::string> warnings;
  if (!damage.empty()) {
    warnings.push_back(damage.what() + "; links may have stale poses (" + damage.where() + ")");
  }
  const std::string text =
      options.json ? forwardKinematicsJson(*links, warnings) : forwardKinematicsText(*links);
  if (Status written = toStandardOutput(text); !written) return written.error();
  for (const std::string& warning : warnings) cli::warn(warning);
  return warnings.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addFkCommand(cli::CommandLine program) {
  auto options = std::make_shared<FkOptions>();
  const cli::CommandLine app =
      program.addSubcommand("fk", "compute the pose of every link for given joint values");
  addFileOptions(app, options->file);
  addPoseOptions(app, options->pose);
  app.addFlag("--json", options->json, "print JSON: LINK to {xyz, quaternion}");
  return {app, [options] { return runFk(*options); }};
}

}  // namespace rocinante
