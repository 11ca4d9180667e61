#include "core/foreign/ros/ros_message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/foreign/ros/signal_messages.h"

namespace rocinante::ros {
namespace {

using namespace std::string_view_literals;

constexpr std::int64_t kNanoseconds = 1'000'000'000;

constexpr std::array kTypes{
    std::pair{"sensor_msgs/JointState"sv, MessageType::joint_state},
    std::pair{"tf2_msgs/TFMessage"sv, MessageType::transforms},
    std::pair{"tf/tfMessage"sv, MessageType::transforms},
    std::pair{"geometry_msgs/PoseStamped"sv, MessageType::pose_stamped},
    std::pair{"nav_msgs/Odometry"sv, MessageType::odometry},
    std::pair{"visualization_msgs/Marker"sv, MessageType::marker},
    std::pair{"visualization_msgs/MarkerArray"sv, MessageType::marker_array},
    std::pair{"rosgraph_msgs/Log"sv, MessageType::log_ros1},
    std::pair{"rcl_interfaces/Log"sv, MessageType::log_ros2},
};

std::int64_t readTime(FieldCursor& cursor) {
  std::int64_t seconds = 0;
  if (cursor.isRos1()) {
    seconds = cursor.number<std::uint32_t>();
  } else {
    seconds = cursor.number<std::int32_t>();
  }
  return seconds * kNanoseconds + cursor.number<std::uint32_t>();
}

Vec3 readVector(FieldCursor& cursor) {
  Vec3 vector;
  vector.x = cursor.number<double>();
  vector.y = cursor.number<double>();
  vector.z = cursor.number<double>();
  return vector;
}

Pose readPose(FieldCursor& cursor) {
  Pose pose;
  pose.position = readVector(cursor);
  pose.orientation.x = cursor.number<double>();
  pose.orientation.y = cursor.number<double>();
  pose.orientation.z = cursor.number<double>();
  pose.orientation.w = cursor.number<double>();
  return pose;
}

std::uint32_t readColor(FieldCursor& cursor) {
  std::uint32_t rgba = 0;
  for (int component = 0; component < 4; ++component) {
    const float value = cursor.number<float>();
    // A NaN is 0.
    const float bounded = value > 0 ? std::min(value, 1.0F) : 0.0F;
    rgba = rgba << 8U | static_cast<std::uint32_t>(std::lround(bounded * 255.0F));
  }
  return rgba;
}

std::string_view levelName(std::uint32_t level, bool ros1) {
  if (ros1) {
    return level >= 16  ? "FATAL"
           : level >= 8 ? "ERROR"
           : level >= 4 ? "WARN"
           : level >= 2 ? "INFO"
                        : "DEBUG";
  }
  return level >= 50   ? "FATAL"
         : level >= 40 ? "ERROR"
         : level >= 30 ? "WARN"
         : level >= 20 ? "INFO"
                       : "DEBUG";
}

/// sensor_msgs/CompressedImage and the texture's coordinates.
void skipTexture(FieldCursor& cursor) {
  cursor.string();
  readHeader(cursor);
  cursor.string();
  cursor.skip(cursor.count(1), 1);
  const std::uint32_t coordinates = cursor.count(8);
  cursor.skip(std::uint64_t{coordinates} * 2, 4);
}

}  // namespace

std::string shortTypeName(std::string_view name) {
  std::string text(name);
  if (const std::size_t kind = text.find("/msg/"); kind != text.npos) text.erase(kind, 4);
  return text;
}

MessageType messageType(std::string_view name) {
  const std::string wanted = shortTypeName(name);
  for (const auto& [known, type] : kTypes) {
    if (known == wanted) return type;
  }
  return signalMessages(wanted).empty() ? MessageType::other : MessageType::signals;
}

std::vector<std::string_view> translatedTypes() {
  std::vector<std::string_view> names;
  for (const auto& type : kTypes) names.push_back(type.first);
  for (const SignalMessage& row : allSignalMessages()) {
    if (std::ranges::find(names, row.type) == names.end()) names.push_back(row.type);
  }
  return names;
}

bool isText(std::string_view type_name) { return shortTypeName(type_name) == "std_msgs/String"; }

std::string_view frameName(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return name;
}

Header readHeader(FieldCursor& cursor) {
  Header header;
  if (cursor.isRos1()) cursor.number<std::uint32_t>();  // seq
  header.stamp_ns = readTime(cursor);
  header.frame = frameName(cursor.string());
  return header;
}

Transform readTransform(FieldCursor& cursor) {
  Transform transform;
  transform.header = readHeader(cursor);
  transform.child = frameName(cursor.string());
  transform.pose = readPose(cursor);
  return transform;
}

Transform readPoseStamped(FieldCursor& cursor) {
  Transform transform;
  transform.header = readHeader(cursor);
  transform.pose = readPose(cursor);
  return transform;
}

LogText readLog(FieldCursor& cursor, bool ros1_fields) {
  LogText log;
  if (ros1_fields) {
    log.header = readHeader(cursor);
  } else {
    log.header.stamp_ns = readTime(cursor);
  }
  log.level = levelName(cursor.number<std::uint8_t>(), ros1_fields);
  log.node = cursor.string();
  log.text = cursor.string();
  const bool in_file = !cursor.string().empty();
  const bool in_function = !cursor.string().empty();
  const bool on_line = cursor.number<std::uint32_t>() != 0;
  log.has_place = in_file || in_function || on_line;
  if (ros1_fields) {
    const std::uint32_t topics = cursor.count(4);
    for (std::uint32_t i = 0; i < topics && cursor.ok(); ++i) cursor.string();
  }
  return log;
}

void readMarker(FieldCursor& cursor, bool textured, Marker& out) {
  out.header = readHeader(cursor);
  out.space = cursor.string();
  out.id = cursor.number<std::int32_t>();
  out.type = cursor.number<std::int32_t>();
  out.action = cursor.number<std::int32_t>();
  out.pose = readPose(cursor);
  out.has_size = readVector(cursor) != Vec3{};
  out.rgba = readColor(cursor);
  // Its seconds are signed, in ROS 1 too.
  out.lifetime_ns = std::int64_t{cursor.number<std::int32_t>()} * kNanoseconds;
  out.lifetime_ns += cursor.number<std::uint32_t>();
  cursor.boolean();  // frame_locked
  const std::uint32_t points = cursor.count(3 * sizeof(double));
  out.points_m.clear();
  out.points_m.reserve(points);
  for (std::uint32_t i = 0; i < points && cursor.ok(); ++i)
    out.points_m.push_back(readVector(cursor));
  const std::uint32_t colors = cursor.count(4 * sizeof(float));
  if (colors > 0) out.rgba = readColor(cursor);
  out.many_colors = colors > 1;
  if (colors > 1) cursor.skip((std::uint64_t{colors} - 1) * 4, sizeof(float));
  if (textured) skipTexture(cursor);
  out.label = cursor.string();
  cursor.string();  // mesh_resource
  if (textured) {
    cursor.string();  // mesh_file: its name and bytes
    cursor.skip(cursor.count(1), 1);
  }
  cursor.boolean();  // mesh_use_embedded_materials
}

}  // namespace rocinante::ros
