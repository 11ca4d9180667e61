
#include "viewer/model/commands.h"
#include "viewer/model/model_info.h"

namespace rocinante {
namespace {

struct InfoOptions {
  ModelFileOptions file;
  bool json = false;
};

Result<cli::Exit> runInfo(const InfoOptions& options) {
  const Result<Cell> cell = loadFile(options.file, true);
  if (!cell) return cell.error();
  const Result<ModelInfo> info = modelInfo(*cell, options.file.device);
  if (!info) return info.error();
  const std::string text = options.json ? modelInfoJson(*info) : modelInfoText(*info);
  if (Status written = toStandardOutput(text); !written) return written.error();
  return cli::Exit::done;
}

}  // namespace

cli::Subcommand addInfoCommand(cli::CommandLine program) {
  auto options = std::make_shared<InfoOptions>();
  const cli::CommandLine app = program.addSubcommand(
      "info", "show a model's tree, joints, limits, size, triangles, textures and faults");
  addFileOptions(app, options->file);
  app.addFlag("--json", options->json, "print JSON");
  return {app, [options] { return runInfo(*options); }};
}

}  // namespace rocinante
