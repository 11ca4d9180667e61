#include <fmt/format.h>

#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "viewer/model/commands.h"
#include "viewer/model/convert.h"

namespace rocinante {
namespace {

struct ConvertOptions {
  ModelFileOptions file;
  PoseOptions pose;
  std::string output;
  bool overwrite = false;
};

Result<cli::Exit> runConvert(const ConvertOptions& options) {
  const Result<PoseRequest> request = poseRequestOf(options.pose, options.file.device);
  if (!request) return request.error();
  const Result<Cell> cell = loadFile(options.file, true);
  if (!cell) return cell.error();
  warnOfFaults(*cell);
  const auto report = convertModel(*cell, {options.output, options.overwrite, *request});
  if (!report) return report.error();
  if (!report->left_out.empty()) cli::warn(accountSentence(report->left_out));
  std::string text;
  for (const auto& file : report->files) text += plainText(file.string()) + "\n";
  text += fmt::format("{}\n", cli::counted(report->triangles, "triangle"));
  if (Status written = toStandardOutput(text); !written) return written.error();
  return cli::Exit::done;
}

}  // namespace

cli::Subcommand addConvertCommand(cli::CommandLine program) {
  auto options = std::make_shared<ConvertOptions>();
  const cli::CommandLine app = program.addSubcommand(
      "convert", "convert geometry, or geometry with kinematics, to another format");
  addFileOptions(app, options->file);
  addPoseOptions(app, options->pose);
  app.addOption("-o,--output", options->output,
                "OUT.obj (posed, a group per link), OUT.stl or OUT.cell.toml (with kinematics)")
      .required();
  app.addFlag("--force", options->overwrite, "overwrite existing files");
  return {app, [options] { return runConvert(*options); }};
}

}  // namespace rocinante
