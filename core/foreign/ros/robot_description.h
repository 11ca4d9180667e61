#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante::ros {

/// The robot that a bag describes, as a cell of one device, named as the robot is.
struct DescribedRobot {
  std::string topic;                 ///< that it was on
  Cell cell;                         ///< without geometry
  std::optional<CellBundle> bundle;  ///< empty when it cannot be attached
  std::vector<std::string> notes;    ///< why not, and which of its files are missing
};

/// A topic `robot_description` of type std_msgs/String, in any namespace.
bool isRobotDescription(const BagTopic& topic);

/// The last URDF on such a topic. Empty when the bag has none; an error when it is not a model.
/// Meshes are looked for as `search` says.
Result<std::optional<DescribedRobot>> describedRobot(BagReader& bag, const ModelSearch& search);

/// The same from the text of a URDF.
Result<DescribedRobot> robotOf(std::string_view urdf, const ModelSearch& search);

}  // namespace rocinante::ros
