#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

struct RobotFile {
  const char* path;
  std::size_t links, joints, values, mesh_triangles;
};

// As data/README.md counts them with urdfdom and assimp. Of R2D2's 952 triangles 144 are its twelve
// shapes, counted there as boxes; the tessellation of a cylinder is our choice.
constexpr RobotFile kRobots[] = {
    {"robots/puma560_description/urdf/puma560_robot.urdf", 7, 6, 6, 8116},
    {"robots/kuka_iiwa/model.urdf", 8, 7, 7, 14758},
    {"robots/franka_panda/panda.urdf", 13, 12, 8, 102759},
    {"robots/r2d2/r2d2.urdf", 16, 15, 8, 808},
    {"robots/kuka_iiwa/objects/tray.urdf", 1, 0, 0, 72},
    {"robots/kuka_iiwa/objects/block.urdf", 1, 0, 0, 0},
};

class RealRobot : public testing::TestWithParam<RobotFile> {};

std::size_t allTriangles(const Model& model) {
  std::size_t count = 0;
  for (const Link& link : model.links) {
    for (const Visual& visual : link.visuals) {
      if (visual.mesh) count += visual.mesh->triangleCount();
    }
  }
  return count;
}

std::size_t shapeTriangles(const Model& model, const urdf::ModelInterface& judge) {
  std::size_t count = 0;
  for (const Link& link : model.links) {
    const auto& visuals = judge.getLink(link.name)->visual_array;
    for (std::size_t i = 0; i < visuals.size(); ++i) {
      if (visuals[i]->geometry->type != urdf::Geometry::MESH) {
        count += link.visuals[i].mesh->triangleCount();
      }
    }
  }
  return count;
}

Mat4 matrixOfUrdf(const urdf::Pose& pose) {
  return matrixOf({{pose.position.x, pose.position.y, pose.position.z},
                   {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}});
}

// Forward kinematics with a tree of the test's own and the C library's trigonometry.
Mat4 judgedPose(const urdf::ModelInterface& judge, const std::string& link_name, const Model& model,
                const JointVector& values) {
  const auto link = judge.getLink(link_name);
  if (!link->parent_joint) return Mat4{1.0};
  const urdf::Joint& joint = *link->parent_joint;
  const std::size_t index = *model.findJoint(joint.name);
  double q = 0.0;
  if (valueCount(model.joints[index].type) == 1) q = values.values[values.first_value[index]];
  Mat4 motion{1.0};
  const double length = std::sqrt(joint.axis.x * joint.axis.x + joint.axis.y * joint.axis.y +
                                  joint.axis.z * joint.axis.z);
  const Vec3 axis = length > 0 ? Vec3{joint.axis.x, joint.axis.y, joint.axis.z} / length : Vec3{};
  if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) {
    motion = rotationMatrix({std::cos(q / 2), axis.x * std::sin(q / 2), axis.y * std::sin(q / 2),
                             axis.z * std::sin(q / 2)});
  } else if (joint.type == urdf::Joint::PRISMATIC) {
    motion = translationMatrix(axis * q);
  }
  return judgedPose(judge, joint.parent_link_name, model, values) *
         matrixOfUrdf(joint.parent_to_joint_origin_transform) * motion;
}

TEST_P(RealRobot, LoadsCompletelyWithoutAnError) {
  ROCINANTE_NEEDS_SHARED_DATA(GetParam().path);
  const auto cell = loadCell(test::sharedData(GetParam().path), {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  for (const Finding& fault : cell->faults) {
    EXPECT_NE(fault.severity, Severity::error) << fault.print();
  }
  const Model* model = cell->modelOf(cell->devices.at(0));
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->links.size(), GetParam().links);
  EXPECT_EQ(model->joints.size(), GetParam().joints);
  EXPECT_EQ(model->positionalCount(), GetParam().values);
  const auto judge = urdf::parseURDFFile(test::sharedData(GetParam().path).string());
  ASSERT_TRUE(judge);
  EXPECT_EQ(allTriangles(*model) - shapeTriangles(*model, *judge), GetParam().mesh_triangles);
}

TEST_P(RealRobot, HasTheLinksJointsAndLimitsThatUrdfdomReads) {
  ROCINANTE_NEEDS_SHARED_DATA(GetParam().path);
  CellOptions options;
  options.geometry = false;
  const auto cell = loadCell(test::sharedData(GetParam().path), options);
  ASSERT_TRUE(cell.ok());
  const Model& model = *cell->modelOf(cell->devices[0]);
  const auto judge = urdf::parseURDFFile(test::sharedData(GetParam().path).string());
  ASSERT_TRUE(judge);
  EXPECT_EQ(model.links.size(), judge->links_.size());
  EXPECT_EQ(model.joints.size(), judge->joints_.size());
  EXPECT_EQ(model.links[model.root].name, judge->getRoot()->name);
  for (const Joint& joint : model.joints) {
    SCOPED_TRACE(joint.name);
    const auto other = judge->getJoint(joint.name);
    ASSERT_TRUE(other);
    EXPECT_EQ(model.links[joint.parent].name, other->parent_link_name);
    EXPECT_EQ(model.links[joint.child].name, other->child_link_name);
    EXPECT_EQ(joint.mimic.has_value(), other->mimic != nullptr);
    if (joint.mimic) {
      EXPECT_EQ(model.joints[joint.mimic->joint].name, other->mimic->joint_name);
      EXPECT_EQ(joint.mimic->multiplier, other->mimic->multiplier);
      EXPECT_EQ(joint.mimic->offset, other->mimic->offset);
    }
    if (joint.type != JointType::revolute && joint.type != JointType::prismatic) continue;
    ASSERT_TRUE(joint.limits);
    ASSERT_TRUE(other->limits);
    EXPECT_EQ(joint.limits->lower, other->limits->lower);
    EXPECT_EQ(joint.limits->upper, other->limits->upper);
    EXPECT_EQ(joint.limits->velocity, other->limits->velocity);
    EXPECT_EQ(joint.limits->effort, other->limits->effort);
  }
}

TEST_P(RealRobot, HasTheShapesThatUrdfdomReads) {
  ROCINANTE_NEEDS_SHARED_DATA(GetParam().path);
  const auto cell = loadCell(test::sharedData(GetParam().path), {});
  ASSERT_TRUE(cell.ok());
  const Model& model = *cell->modelOf(cell->devices[0]);
  const auto judge = urdf::parseURDFFile(test::sharedData(GetParam().path).string());
  ASSERT_TRUE(judge);
  for (const Link& link : model.links) {
    SCOPED_TRACE(link.name);
    const auto other = judge->getLink(link.name);
    ASSERT_TRUE(other);
    ASSERT_EQ(link.visuals.size(), other->visual_array.size());
    ASSERT_EQ(link.collisions.size(), other->collision_array.size());
    for (std::size_t i = 0; i < link.visuals.size(); ++i) {
      const Visual& ours = link.visuals[i];
      const urdf::Visual& theirs = *other->visual_array[i];
      ASSERT_TRUE(ours.mesh);
      const Vec3 apart = transformPoint(matrixOf(ours.origin), {1, 1, 1}) -
                         transformPoint(matrixOfUrdf(theirs.origin), {1, 1, 1});
      EXPECT_LT(glm::length(apart), 1e-12);
      if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(theirs.geometry.get())) {
        EXPECT_EQ(ours.scale, Vec3(mesh->scale.x, mesh->scale.y, mesh->scale.z));
      } else if (const auto* box = dynamic_cast<const urdf::Box*>(theirs.geometry.get())) {
        const Vec3 size = ours.mesh->bounds.max - ours.mesh->bounds.min;
        EXPECT_LT(glm::length(size - Vec3(box->dim.x, box->dim.y, box->dim.z)), 1e-6);
      } else if (const auto* tube = dynamic_cast<const urdf::Cylinder*>(theirs.geometry.get())) {
        EXPECT_NEAR(ours.mesh->bounds.max.z * 2, tube->length, 1e-6);
        EXPECT_NEAR(ours.mesh->bounds.max.x, tube->radius, 1e-6);
      } else if (const auto* ball = dynamic_cast<const urdf::Sphere*>(theirs.geometry.get())) {
        EXPECT_NEAR(ours.mesh->bounds.max.z, ball->radius, 1e-6);
      }
    }
  }
}

TEST_P(RealRobot, StandsWhereUrdfdomsTreePutsItAlsoFarFromTheOrigin) {
  ROCINANTE_NEEDS_SHARED_DATA(GetParam().path);
  CellOptions options;
  options.geometry = false;
  const auto cell = loadCell(test::sharedData(GetParam().path), options);
  ASSERT_TRUE(cell.ok());
  const Model& model = *cell->modelOf(cell->devices[0]);
  const auto judge = urdf::parseURDFFile(test::sharedData(GetParam().path).string());
  ASSERT_TRUE(judge);
  const Mat4 base = matrixOf({{100, -100, 3}, quaternionFromRpy({0.1, 0.2, 2.0})});
  std::mt19937_64 random(560);
  std::uniform_real_distribution<double> values(-3.2, 3.2);
  double worst = 0.0;
  for (int turn = 0; turn < 200; ++turn) {
    JointVector joints = zeroJoints(model);
    for (double& value : joints.values) value = values(random);
    applyMimics(model, joints);
    const std::vector<Mat4> poses = linkPoses(model, joints);
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      const Mat4 judged = judgedPose(*judge, model.links[i].name, model, joints);
      for (const Vec3 point : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const Mat4& from : {Mat4{1.0}, base}) {
          const Vec3 apart =
              transformPoint(from * poses[i], point) - transformPoint(from * judged, point);
          worst = std::max({worst, std::fabs(apart.x), std::fabs(apart.y), std::fabs(apart.z)});
        }
      }
    }
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(worst, 1e-12) << "and far better, in double";
}

INSTANTIATE_TEST_SUITE_P(OfTheSharedData, RealRobot, testing::ValuesIn(kRobots),
                         [](const auto& each) {
                           const std::filesystem::path path(each.param.path);
                           const std::string name = path.parent_path().filename().string();
                           if (name == "urdf") return std::string("puma560");
                           return name == "objects" ? path.stem().string() : name;
                         });

TEST(RealRobots, AreAllHeldAgainstUrdfdom) {
  ROCINANTE_NEEDS_SHARED_DATA("robots");
  std::set<std::filesystem::path> held, there;
  for (const RobotFile& robot : kRobots) held.insert(test::sharedData(robot.path));
  const std::filesystem::recursive_directory_iterator all(test::sharedData());
  for (const auto& entry : all) {
    if (entry.path().extension() == ".urdf") there.insert(entry.path());
  }
  EXPECT_EQ(held, there);
}

}  // namespace
}  // namespace rocinante
