#include "viewer/ui/program/save_pose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "viewer/ui/model/pose_edit.h"

namespace rocinante {
namespace {

Error refused(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

/// The file that was written.
Result<std::filesystem::path> saveOne(ViewModel& model, const std::filesystem::path& cell_file,
                                      const std::string& name, bool included) {
  const CellDevice* const device = model.cell().findDevice(name);
  if (device == nullptr) return refused(fmt::format("the cell has no device `{}`", name));
  const auto file = fileOfDevice(cell_file, model.cell().files, name);
  if (!file.ok()) return file.error();
  if (*file != cell_file && !included) {
    return refused(
        fmt::format("{} is of {}, which other cells may include, too: `save-pose {} "
                    "included` changes that file",
                    name, file->filename().string(), name));
  }
  const Pose* const last = model.moves.findSaved(name);
  const Pose* const moved = model.moves.find(name);
  const Pose& now = moved != nullptr ? *moved : device->pose;
  if (auto saved = savePose(*file, name, last != nullptr ? *last : device->pose, now); !saved) {
    return saved.error();
  }
  model.moves.saved(name, now);
  return *file;
}

}  // namespace

Result<std::string> savePoses(ViewModel& model, const std::filesystem::path& cell_file,
                              const PoseRequest& wanted) {
  // Its files are in a folder of ours, which is gone with the window.
  if (model.cell().keeps_files != nullptr) {
    return refused("the cell came with the log: there is no file to write into");
  }
  model.moves.settle();
  std::vector<std::string> names = model.moves.unsaved();
  if (!wanted.device.empty()) {
    const bool is_unsaved = std::ranges::find(names, wanted.device) != names.end();
    names.clear();
    if (is_unsaved) names.push_back(wanted.device);
  }
  if (names.empty()) {
    return refused(wanted.device.empty()
                       ? std::string("no device was moved since the cell was written")
                       : fmt::format("`{}` is where the cell has it", wanted.device));
  }
  std::vector<std::string> written;
  for (const std::string& name : names) {
    const auto file = saveOne(model, cell_file, name, wanted.included);
    if (!file.ok() && !written.empty()) {
      Error fault = file.error();
      fault.what += fmt::format("; saved before that: {}", fmt::join(written, ", "));
      return fault;
    }
    if (!file.ok()) return file.error();
    written.push_back(fmt::format("{} in {}", name, file->filename().string()));
  }
  return fmt::format("saved: {}", fmt::join(written, ", "));
}

}  // namespace rocinante
