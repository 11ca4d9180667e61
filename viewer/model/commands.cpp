#include "viewer/model/commands.h"

#include <fmt/format.h>

#include <cstdio>

#include "core/base/number_list.h"
#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/cell/view_path.h"
#include "core/cli/load_progress.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/math/transform.h"

namespace rocinante {

void addFileOptions(cli::CommandLine app, ModelFileOptions& options) {
  app.addOption("FILE", options.file,
                "a model (.urdf, .obj, .stl ...), a *.cell.toml or a log that carries its cell")
      .required();
  cli::addSearchOptions(app, options);
  app.addFlag("--strict", options.strict, "refuse a model with errors");
  app.addOption("--device", options.device, "only this device of a cell");
}

Result<Cell> loadFile(const ModelFileOptions& options, bool geometry) {
  CellOptions how;
  static_cast<ModelSearch&>(how) = options;
  how.geometry = geometry;
  how.strict = options.strict;
  how.parallel = cli::workerThreads();
  how.progress = cli::loadProgress(options.file);
  Result<Cell> cell = loadCellOrLog(options.file, how);
  if (!cell) return cell.error();
  if (!options.device.empty() && cell->findDevice(options.device) == nullptr) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the cell has no device `{}`", plainText(options.device)),
                 options.file};
  }
  return cell;
}

void addPoseOptions(cli::CommandLine app, PoseOptions& options) {
  app.addOption("--joints", options.positions,
                "all joint values in the file's order: \"0 -0.785 0 -2.356\", or \"DEVICE=0 ...\"");
  app.addOption("--joint", options.named, "NAME=VALUE of one joint; repeatable");
  app.addFlag("--degrees", options.degrees, "values of rotating joints are degrees");
  app.addOption("--pose", options.base, "pose of the device: \"x y z\" or \"x y z qx qy qz qw\"");
  const cli::Option at = app.addOption(
      "--at", options.at, "a session time: 12.5s, -1s, RFC 3339, or the text of an event");
  const cli::Option event =
      app.addOption("--event", options.event, "the event with this text (* and ?)");
  event.valueText("PATTERN").excludes(at);
  app.addOption("--log", options.log, "take joint values from this session");
}

Result<PoseRequest> poseRequestOf(const PoseOptions& options, const std::string& device) {
  PoseRequest request;
  request.device = device;
  request.degrees = options.degrees;
  request.log = options.log;
  request.event = options.event;
  request.at = options.at;
  const auto refused = [](std::string what, std::string where) {
    return Error{ErrorKind::bad_argument, std::move(what), std::move(where)};
  };
  if (!options.log.empty() && options.at.empty() && options.event.empty()) {
    return refused("--log requires --at or --event", "");
  }
  if (!options.positions.empty()) {
    // Numbers have no `=`: what stands before it is the device, as `view` copies it.
    const std::size_t equals = options.positions.rfind('=');
    const std::size_t numbers = equals == std::string::npos ? 0 : equals + 1;
    if (numbers > 0) {
      const auto named = parseViewPath(std::string_view(options.positions).substr(0, equals));
      const bool is_device =
          named && !named->path.is_layer && !named->all_devices && named->path.second.empty();
      if (!is_device || (!device.empty() && device != named->path.first)) {
        return refused(fmt::format("`{}` is not the device", plainText(options.positions)),
                       "--joints");
      }
      request.device = named->path.first;
    }
    Result<std::vector<double>> values =
        parseNumbers(std::string_view(options.positions).substr(numbers));
    if (!values) return refused(values.error().what, "--joints");
    request.joints = std::move(*values);
  }
  for (const std::string& text : options.named) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) {
      return refused(fmt::format("`{}` is not NAME=VALUE", plainText(text)), "--joint");
    }
    const Result<std::vector<double>> value = parseNumbers(text.substr(equals + 1));
    if (!value || value->size() != 1) {
      return refused(fmt::format("`{}` is not NAME=VALUE", plainText(text)), "--joint");
    }
    request.named.emplace_back(text.substr(0, equals), value->front());
  }
  if (!options.base.empty()) {
    const Result<std::vector<double>> v = parseNumbers(options.base);
    if (!v) return refused(v.error().what, "--pose");
    if (v->size() != 3 && v->size() != 7) {
      return refused("a pose must be x y z or x y z qx qy qz qw", "--pose");
    }
    Pose pose;
    pose.position = {(*v)[0], (*v)[1], (*v)[2]};
    if (v->size() == 7) {
      const auto turn = normalized(Quat{(*v)[6], (*v)[3], (*v)[4], (*v)[5]});
      if (!turn)
        return refused("the quaternion is zero; the identity rotation is 0 0 0 1", "--pose");
      pose.orientation = *turn;
    }
    request.base = pose;
  }
  return request;
}

void warnOfFaults(const Cell& cell) {
  for (const Finding& fault : cell.faults) {
    if (fault.severity == Severity::note) continue;
    cli::warn(plainText(cell.shown(fault.print())));
  }
}

Status toStandardOutput(std::string_view text) {
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return Status{};
  return Error{ErrorKind::refused, "cannot write to standard output", "stdout"};
}

}  // namespace rocinante
