#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/vector.h"
#include "core/mesh/mesh.h"

namespace rocinante {

enum class JointType : std::uint8_t {
  fixed,
  revolute,
  continuous,
  prismatic,
  planar,    ///< three values: x y yaw
  floating,  ///< seven values: x y z qx qy qz qw
};
std::string_view nameOf(JointType type);
/// How many values a sender gives for it: 0, 1, 1, 1, 3, 7.
std::size_t valueCount(JointType type);

struct JointLimits {
  double lower = 0, upper = 0;  ///< radians or metres
  std::optional<double> velocity, effort;
};

struct Mimic {
  std::size_t joint = 0;  ///< into Model::joints
  double multiplier = 1, offset = 0;
};

struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  std::size_t parent = 0;  ///< into Model::links
  std::size_t child = 0;
  Pose origin;  ///< of the child in the parent at zero
  /// Unit length, in the child's space: the axis it turns about or slides along. For a planar joint
  /// the normal of its plane; docs/cell-format.md, section "Joints", defines its x and y.
  Vec3 axis{1, 0, 0};
  std::optional<JointLimits> limits;
  std::optional<Mimic> mimic;
};

/// A piece of geometry of a link. Several visuals share one mesh.
struct Visual {
  std::string name;
  Pose origin;                          ///< in the link
  Vec3 scale{1, 1, 1};                  ///< negative mirrors
  std::shared_ptr<const Mesh> mesh;     ///< null when its file is missing (a fault says so)
  std::vector<std::size_t> mesh_parts;  ///< which parts of the mesh; empty: all
  std::optional<Material> material;     ///< replaces the mesh's own
};

struct Link {
  std::string name;
  std::optional<std::size_t> parent_joint;  ///< into Model::joints; empty for the root
  std::vector<Visual> visuals;
  std::vector<Visual> collisions;
};

/// One value of one joint, by name.
struct JointValue {
  std::size_t joint = 0;      ///< into Model::joints
  std::size_t component = 0;  ///< below valueCount of its type
};

/// Kinematics with geometry: a tree of links and joints. Immutable once read; shared by devices.
struct Model {
  std::string name;
  std::string file;
  std::vector<Link> links;                ///< as the file has them
  std::vector<Joint> joints;              ///< as the file has them (the order of positional values)
  std::size_t root = 0;                   ///< into links
  std::vector<std::size_t> update_order;  ///< joints so that each comes after its parent's
  /// Names to places in `links` and `joints`; readers fill them; when empty, lookups search
  /// linearly.
  std::map<std::string, std::size_t, std::less<>> link_by_name, joint_by_name;

  std::optional<std::size_t> findLink(std::string_view link_name) const;
  std::optional<std::size_t> findJoint(std::string_view joint_name) const;
  /// The value that `joint NAME=q` and `order` name: the joint of that name when it has one value,
  /// else NAME.x NAME.y NAME.yaw of a planar and NAME.x .y .z .qx .qy .qz .qw of a floating joint.
  /// Empty for unknown, fixed and mimic joints.
  std::optional<JointValue> findJointValue(std::string_view value_name) const;
  /// Joints that a sender drives, in order: not fixed, not mimic.
  std::vector<std::size_t> movableJoints() const;
  /// Values in a full positional `joints`: the sum of valueCount over the movable joints.
  std::size_t positionalCount() const;
};

}  // namespace rocinante
