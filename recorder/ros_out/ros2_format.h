#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/foreign/session/message_sink.h"
#include "core/foreign/session/session_format.h"

namespace rocinante {

/// The schema of a ROS 2 message that is written here (Humble and later), with everything it refers
/// to, as MCAP's encoding "ros2msg" has it. `name` is one of tf2_msgs/msg/TFMessage,
/// sensor_msgs/msg/JointState, visualization_msgs/msg/MarkerArray, std_msgs/msg/String,
/// .../Float64,
/// .../Bool, rcl_interfaces/msg/Log.
const MessageSchema& ros2Schema(std::string_view name);

/// Metres that a pixel of a line or a point becomes: markers have no sizes in pixels.
inline constexpr double kMarkerMetresPerPixel = 0.002;
/// Height of a label, metres.
inline constexpr double kMarkerTextMetres = 0.1;

/// A ROS 2 bag: TFMessage on /tf, JointState on /DEVICE/joint_states with the velocities and
/// efforts that signals JOINT.velocity and JOINT.effort state, Float64, Bool and String of other
/// signals on /signals/PATH/NAME, String with the URDF on /DEVICE/robot_description, MarkerArray on
/// /SOURCE/markers, Log on /rosout. Times are log times.
std::unique_ptr<SessionFormat> makeRos2Format();

/// A name as ROS has topics: letters, digits and `_`, not beginning with a digit; anything else is
/// `_`.
std::string rosName(std::string_view name);

}  // namespace rocinante
