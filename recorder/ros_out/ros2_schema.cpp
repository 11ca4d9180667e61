#include <map>

#include "recorder/ros_out/ros2_format.h"

namespace rocinante {
namespace {

#define ROCINANTE_ROS2_HEADER                                                          \
  "================================================================================\n" \
  "MSG: std_msgs/Header\n"                                                             \
  "builtin_interfaces/Time stamp\n"                                                    \
  "string frame_id\n"                                                                  \
  "================================================================================\n" \
  "MSG: builtin_interfaces/Time\n"                                                     \
  "int32 sec\n"                                                                        \
  "uint32 nanosec\n"
#define ROCINANTE_ROS2_NEXT \
  "================================================================================\nMSG: "

struct Ros2Definition {
  const char* name;
  const char* text;
};

/// Fields and constants as the published interfaces have them; `builtin_interfaces/Time` is written
/// out, for readers that do not know it.
constexpr Ros2Definition kRos2Definitions[] = {
    {"tf2_msgs/msg/TFMessage",
     "geometry_msgs/TransformStamped[] transforms\n" ROCINANTE_ROS2_NEXT
     "geometry_msgs/TransformStamped\n"
     "std_msgs/Header header\n"
     "string child_frame_id\n"
     "geometry_msgs/Transform transform\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Transform\n"
     "geometry_msgs/Vector3 translation\n"
     "geometry_msgs/Quaternion rotation\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Vector3\n"
     "float64 x\nfloat64 y\nfloat64 z\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Quaternion\n"
     "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" ROCINANTE_ROS2_HEADER},
    {"sensor_msgs/msg/JointState",
     "std_msgs/Header header\n"
     "string[] name\n"
     "float64[] position\n"
     "float64[] velocity\n"
     "float64[] effort\n" ROCINANTE_ROS2_HEADER},
    {"visualization_msgs/msg/MarkerArray",
     "visualization_msgs/Marker[] markers\n" ROCINANTE_ROS2_NEXT "visualization_msgs/Marker\n"
     "int32 ARROW=0\nint32 CUBE=1\nint32 SPHERE=2\nint32 CYLINDER=3\nint32 LINE_STRIP=4\n"
     "int32 LINE_LIST=5\nint32 CUBE_LIST=6\nint32 SPHERE_LIST=7\nint32 POINTS=8\n"
     "int32 TEXT_VIEW_FACING=9\nint32 MESH_RESOURCE=10\nint32 TRIANGLE_LIST=11\n"
     "int32 ADD=0\nint32 MODIFY=0\nint32 DELETE=2\nint32 DELETEALL=3\n"
     "std_msgs/Header header\n"
     "string ns\nint32 id\nint32 type\nint32 action\n"
     "geometry_msgs/Pose pose\n"
     "geometry_msgs/Vector3 scale\n"
     "std_msgs/ColorRGBA color\n"
     "builtin_interfaces/Duration lifetime\n"
     "bool frame_locked\n"
     "geometry_msgs/Point[] points\n"
     "std_msgs/ColorRGBA[] colors\n"
     "string texture_resource\n"
     "sensor_msgs/CompressedImage texture\n"
     "visualization_msgs/UVCoordinate[] uv_coordinates\n"
     "string text\n"
     "string mesh_resource\n"
     "visualization_msgs/MeshFile mesh_file\n"
     "bool mesh_use_embedded_materials\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Pose\n"
     "geometry_msgs/Point position\n"
     "geometry_msgs/Quaternion orientation\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Point\n"
     "float64 x\nfloat64 y\nfloat64 z\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Quaternion\n"
     "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" ROCINANTE_ROS2_NEXT "geometry_msgs/Vector3\n"
     "float64 x\nfloat64 y\nfloat64 z\n" ROCINANTE_ROS2_NEXT "std_msgs/ColorRGBA\n"
     "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n" ROCINANTE_ROS2_NEXT
     "builtin_interfaces/Duration\n"
     "int32 sec\nuint32 nanosec\n" ROCINANTE_ROS2_NEXT "sensor_msgs/CompressedImage\n"
     "std_msgs/Header header\n"
     "string format\nuint8[] data\n" ROCINANTE_ROS2_NEXT "visualization_msgs/UVCoordinate\n"
     "float32 u\nfloat32 v\n" ROCINANTE_ROS2_NEXT "visualization_msgs/MeshFile\n"
     "string filename\nuint8[] data\n" ROCINANTE_ROS2_HEADER},
    {"std_msgs/msg/String", "string data\n"},
    {"std_msgs/msg/Float64", "float64 data\n"},
    {"std_msgs/msg/Bool", "bool data\n"},
    {"rcl_interfaces/msg/Log",
     "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\n"
     "builtin_interfaces/Time stamp\n"
     "uint8 level\n"
     "string name\nstring msg\nstring file\nstring function\nuint32 line\n" ROCINANTE_ROS2_NEXT
     "builtin_interfaces/Time\n"
     "int32 sec\nuint32 nanosec\n"},
};

#undef ROCINANTE_ROS2_HEADER
#undef ROCINANTE_ROS2_NEXT

}  // namespace

const MessageSchema& ros2Schema(std::string_view name) {
  static const std::map<std::string, MessageSchema, std::less<>> kSchemas = [] {
    std::map<std::string, MessageSchema, std::less<>> schemas;
    for (const Ros2Definition& each : kRos2Definitions) {
      const ByteView text = bytesOf(each.text);
      schemas.emplace(each.name,
                      MessageSchema{each.name, "ros2msg", Bytes(text.begin(), text.end()), "cdr"});
    }
    return schemas;
  }();
  return kSchemas.find(name)->second;
}

}  // namespace rocinante
