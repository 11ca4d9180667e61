#include "core/foreign/foxglove/foxglove_schemas.h"

#include <map>
#include <string>

#include "core/foreign/proto/proto_schema.h"

namespace rocinante {
namespace {

/// Whole, though most primitives are never written: readers expect every field of an entity.
constexpr ProtoMessage kFoxgloveMessages[] = {
    {"Vector3", "double x=1; double y=2; double z=3", ""},
    {"Quaternion", "double x=1; double y=2; double z=3; double w=4", ""},
    {"Pose", "Vector3 position=1; Quaternion orientation=2", ""},
    {"Point3", "double x=1; double y=2; double z=3", ""},
    {"Color", "double r=1; double g=2; double b=3; double a=4", ""},
    {"KeyValuePair", "string key=1; string value=2", ""},
    {"FrameTransform",
     "Timestamp timestamp=1; string parent_frame_id=2; string child_frame_id=3; "
     "Vector3 translation=4; Quaternion rotation=5",
     ""},
    {"FrameTransforms", "repeated FrameTransform transforms=1", ""},
    {"JointState",
     "string name=1; optional double position=2; optional double velocity=3; "
     "optional double acceleration=4; optional double effort=5",
     ""},
    {"JointStates", "Timestamp timestamp=1; repeated JointState joints=2", ""},
    {"Log",
     "Timestamp timestamp=1; Level level=2; string message=3; string name=4; string "
     "file=5; fixed32 line=6",
     "Level UNKNOWN=0 DEBUG=1 INFO=2 WARNING=3 ERROR=4 FATAL=5"},
    {"PackedElementField", "string name=1; fixed32 offset=2; NumericType type=3",
     "NumericType UNKNOWN=0 UINT8=1 INT8=2 UINT16=3 INT16=4 UINT32=5 INT32=6 "
     "FLOAT32=7 FLOAT64=8"},
    {"PointCloud",
     "Timestamp timestamp=1; string frame_id=2; Pose pose=3; fixed32 point_stride=4; "
     "repeated PackedElementField fields=5; bytes data=6",
     ""},
    {"ArrowPrimitive",
     "Pose pose=1; double shaft_length=2; double shaft_diameter=3; double "
     "head_length=4; double head_diameter=5; Color color=6",
     ""},
    {"CubePrimitive", "Pose pose=1; Vector3 size=2; Color color=3", ""},
    {"SpherePrimitive", "Pose pose=1; Vector3 size=2; Color color=3", ""},
    {"CylinderPrimitive",
     "Pose pose=1; Vector3 size=2; double bottom_scale=3; double top_scale=4; Color "
     "color=5",
     ""},
    {"LinePrimitive",
     "Type type=1; Pose pose=2; double thickness=3; bool scale_invariant=4; repeated "
     "Point3 points=5; Color color=6; repeated Color colors=7; repeated fixed32 "
     "indices=8",
     "Type LINE_STRIP=0 LINE_LOOP=1 LINE_LIST=2"},
    {"TriangleListPrimitive",
     "Pose pose=1; repeated Point3 points=2; Color color=3; repeated Color colors=4; "
     "repeated fixed32 indices=5",
     ""},
    {"TextPrimitive",
     "Pose pose=1; bool billboard=2; double font_size=3; bool scale_invariant=4; "
     "Color color=5; string text=6",
     ""},
    {"ModelPrimitive",
     "Pose pose=1; Vector3 scale=2; Color color=3; bool override_color=4; string "
     "url=5; string media_type=6; bytes data=7",
     ""},
    {"SceneEntityDeletion", "Timestamp timestamp=1; Type type=2; string id=3",
     "Type MATCHING_ID=0 ALL=1"},
    {"SceneEntity",
     "Timestamp timestamp=1; string frame_id=2; string id=3; Duration lifetime=4; "
     "bool frame_locked=5; repeated KeyValuePair metadata=6; repeated ArrowPrimitive "
     "arrows=7; repeated CubePrimitive cubes=8; repeated SpherePrimitive spheres=9; "
     "repeated CylinderPrimitive cylinders=10; repeated LinePrimitive lines=11; "
     "repeated TriangleListPrimitive triangles=12; repeated TextPrimitive texts=13; "
     "repeated ModelPrimitive models=14",
     ""},
    {"SceneUpdate", "repeated SceneEntityDeletion deletions=1; repeated SceneEntity entities=2",
     ""},
};

MessageSchema madeSchema(std::string_view name) {
  return {"foxglove." + std::string(name), "protobuf",
          fileDescriptorSet("foxglove", kFoxgloveMessages, name), "protobuf"};
}

}  // namespace

const MessageSchema& foxgloveSchema(std::string_view name) {
  static const std::map<std::string, MessageSchema, std::less<>> kSchemas = [] {
    std::map<std::string, MessageSchema, std::less<>> schemas;
    for (const std::string_view each :
         {"FrameTransforms", "JointStates", "SceneUpdate", "PointCloud", "Log"}) {
      schemas.emplace(each, madeSchema(each));
    }
    return schemas;
  }();
  return kSchemas.find(name)->second;
}

}  // namespace rocinante
