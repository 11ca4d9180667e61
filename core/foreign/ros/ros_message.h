#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/ros/field_cursor.h"
#include "core/math/vector.h"

/// The messages that are translated, field by field as their definitions have them
/// (https://docs.ros.org, packages common_interfaces and geometry2). Text is borrowed from the
/// message. A reader leaves the cursor failed when the message does not fit its definition.
namespace rocinante::ros {

/// The message types that are translated to packets.
enum class MessageType : std::uint8_t {
  other,  ///< kept as it is
  joint_state,
  transforms,
  pose_stamped,
  odometry,
  marker,
  marker_array,
  log_ros1,
  log_ros2,
  signals,  ///< of signal_messages.h
};

/// "sensor_msgs/JointState" of "sensor_msgs/msg/JointState", as ROS 2 writes it.
std::string shortTypeName(std::string_view name);
/// Of either.
MessageType messageType(std::string_view name);
/// All types that are translated, by their short names.
std::vector<std::string_view> translatedTypes();
/// True for std_msgs/String.
bool isText(std::string_view type_name);

struct Header {
  std::int64_t stamp_ns = 0;  ///< since the epoch; 0 when it was not set
  std::string_view frame;     ///< without a leading slash
};
Header readHeader(FieldCursor& cursor);
/// Without the slash that tf of ROS 1 allowed in front.
std::string_view frameName(std::string_view name);

struct Transform {
  Header header;
  std::string_view child;  ///< frame, without a leading slash
  Pose pose;  ///< of `child` in `header.frame`; the rotation as stored, not of unit length
};
/// One geometry_msgs/TransformStamped, or the begin of a nav_msgs/Odometry.
Transform readTransform(FieldCursor& cursor);
/// The fewest bytes of a TransformStamped: bounds a sequence's count.
inline constexpr std::size_t kLeastTransformBytes = 7 * 8 + 16;

/// geometry_msgs/PoseStamped, with an empty `child`.
Transform readPoseStamped(FieldCursor& cursor);

struct LogText {
  Header header;
  std::string_view level;  ///< "WARN"
  std::string_view node, text;
  bool has_place = false;  ///< a file, a function or a line
};
/// rosgraph_msgs/Log and rcl_interfaces/Log.
LogText readLog(FieldCursor& cursor, bool ros1_fields);

struct Marker {
  enum Type : std::int32_t { line_strip = 4, line_list = 5, points = 8, text = 9 };
  enum Action : std::int32_t { add = 0, erase = 2, erase_all = 3 };

  Header header;
  std::string_view space;  ///< `ns`
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = 0;
  Pose pose;
  bool has_size = false;
  std::uint32_t rgba = 0;  ///< that of its first point when the points have colours
  std::int64_t lifetime_ns = 0;
  std::vector<Vec3> points_m;
  bool many_colors = false;
  std::string_view label;
};
/// visualization_msgs/Marker. Its definition grew twice in ROS 2; `textured` is that since Humble.
void readMarker(FieldCursor& cursor, bool textured, Marker& out);
/// The fewest bytes of a Marker.
inline constexpr std::size_t kLeastMarkerBytes = 140;

}  // namespace rocinante::ros
