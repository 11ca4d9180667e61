#include "core/foreign/ros/robot_description.h"

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/bundle/private_folder.h"
#include "core/foreign/ros/ros_message.h"

namespace rocinante::ros {
namespace {

/// As loadCell() names the device after the file.
bool isFileName(std::string_view name) {
  const auto is_plain = [](char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
           (byte >= '0' && byte <= '9') || byte == '_' || byte == '-';
  };
  return !name.empty() && name.size() <= 200 && std::ranges::all_of(name, is_plain);
}

Result<std::filesystem::path> written(const std::filesystem::path& folder, std::string_view name,
                                      std::string_view urdf) {
  std::filesystem::path path = folder / (std::string(name) + ".urdf");
  if (Status done = writeFileWhole(path, bytesOf(urdf), true, Sync::later); !done) {
    return done.error();
  }
  return path;
}

}  // namespace

bool isRobotDescription(const BagTopic& topic) {
  const bool is_named =
      topic.name == "robot_description" || topic.name.ends_with("/robot_description");
  return is_named && isText(topic.type);
}

Result<DescribedRobot> robotOf(std::string_view urdf, const ModelSearch& search) {
  const auto folder = PrivateFolder::make();
  if (!folder) return folder.error();
  CellOptions options;
  static_cast<ModelSearch&>(options) = search;
  options.geometry = false;
  Result<std::filesystem::path> path = written((*folder)->path(), "robot", urdf);
  if (!path) return path.error();
  Result<Cell> cell = loadCell(*path, options);
  const auto place = [](Error error) {
    error.where = "robot_description";
    return error;
  };
  if (!cell) return place(cell.error());
  const Model* const model = cell->devices.empty() ? nullptr : cell->modelOf(cell->devices.front());
  if (model == nullptr) {
    return place({ErrorKind::damaged, "the robot description is not a URDF", {}});
  }
  if (isFileName(model->name) && model->name != "robot") {
    path = written((*folder)->path(), model->name, urdf);
    if (!path) return path.error();
    cell = loadCell(*path, options);
    if (!cell) return place(cell.error());
  }
  DescribedRobot robot;
  robot.cell = std::move(*cell);
  // Elsewhere a bag's packages are rarely found; without meshes it can still be posed and compared.
  Result<CellBundle> bundle = collectCell(*path, options, MissingMeshes::left_out);
  if (bundle) {
    const auto missing = std::ranges::count_if(
        bundle->manifest.names,
        [](const BundleManifest::Name& name) { return name.why == FoundFile::Why::missing; });
    if (missing > 0) {
      robot.notes.push_back(countText(static_cast<std::uint64_t>(missing), "file") +
                            " of the robot description not found; --search and --package say where "
                            "to look");
    }
    robot.bundle = std::move(*bundle);
  } else {
    robot.notes.push_back("the log does not carry the robot description: " + bundle.error().what);
  }
  return robot;
}

Result<std::optional<DescribedRobot>> describedRobot(BagReader& bag, const ModelSearch& search) {
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    const std::optional<FieldCursor::Layout> layout = topic.layout();
    if (!isRobotDescription(topic) || !layout) continue;
    const Result<std::optional<Bytes>> message = bag.lastOf(i);
    if (!message) return message.error();
    if (!*message) continue;
    FieldCursor cursor(**message, *layout);
    const std::string_view urdf = cursor.string();
    if (!cursor.ok()) {
      return Error{ErrorKind::damaged, "the robot description is not a whole message", topic.name};
    }
    Result<DescribedRobot> robot = robotOf(urdf, search);
    if (!robot) return robot.error();
    robot->topic = topic.name;
    return std::optional(std::move(*robot));
  }
  return std::optional<DescribedRobot>();
}

}  // namespace rocinante::ros
