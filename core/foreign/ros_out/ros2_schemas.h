#pragma once

#include <string_view>

#include "core/foreign/session/message_schema.h"

namespace rocinante {

/// The schema of a ROS 2 message that is written here (Humble and later), with everything it refers
/// to, as MCAP's encoding "ros2msg" has it. `name` is one of tf2_msgs/msg/TFMessage,
/// sensor_msgs/msg/JointState, visualization_msgs/msg/MarkerArray, std_msgs/msg/String,
/// rcl_interfaces/msg/Log.
const MessageSchema& ros2Schema(std::string_view name);

}  // namespace rocinante
