#include "core/kinematics/mesh_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A chain of links, half a metre from one to the next.
Model chainOf(std::size_t joints) {
  Model model;
  model.links.resize(joints + 1);
  for (std::size_t i = 0; i < joints; ++i) {
    Joint joint;
    joint.parent = i;
    joint.child = i + 1;
    joint.origin.position = {0, 0, 0.5};
    model.joints.push_back(joint);
  }
  return model;
}

MeshUse visual(std::string link, double size_m, int line = 0) {
  return {link, link + ".stl", false, size_m, {line, 1}};
}
MeshUse collision(std::string link, double size_m, int line = 0) {
  return {link, link + ".stl", true, size_m, {line, 1}};
}

std::vector<std::string> judged(const Model& model, const std::vector<MeshUse>& uses) {
  Findings faults;
  {
    FaultList list(faults, "arm.urdf");
    judgeScale(model, uses, list);
  }
  std::vector<std::string> lines;
  for (const Finding& fault : faults) {
    EXPECT_EQ(fault.rule, "model.scale");
    EXPECT_EQ(fault.severity, Severity::warning);
    EXPECT_THAT(fault.hint, HasSubstr("millimetres"));
    lines.push_back(std::to_string(fault.line) + ": " + fault.text);
  }
  return lines;
}

TEST(ModelScale, AVisualInInchesBesideItsCollisionIsTold) {
  const Model model = chainOf(1);
  EXPECT_THAT(judged(model, {visual("a", 0.5 * 39.37, 3), collision("a", 0.5, 4)}),
              ElementsAre("3: the visual `a.stl` of link `a` is 19.7 m large, and its collision "
                          "0.5 m"));
  EXPECT_THAT(judged(model, {visual("a", 0.5, 3), collision("a", 500, 4)}),
              ElementsAre("4: the collision `a.stl` of link `a` is 500 m large, and its visual "
                          "0.5 m"));
}

TEST(ModelScale, CoarseCollisionShapesAreNoFault) {
  const Model model = chainOf(1);
  EXPECT_THAT(judged(model, {visual("a", 0.5), collision("a", 3.9)}), IsEmpty());
  EXPECT_THAT(judged(model, {visual("a", 3.9), collision("a", 0.5)}), IsEmpty());
  // A link of two parts is compared with the larger one.
  EXPECT_THAT(judged(model, {visual("a", 0.01), visual("a", 0.5), collision("a", 0.6)}), IsEmpty());
}

TEST(ModelScale, OneMeshInMillimetresAmongOthersInMetresIsTold) {
  EXPECT_THAT(judged(chainOf(3),
                     {visual("a", 0.3), visual("b", 300, 7), visual("c", 0.4), visual("d", 0.2)}),
              ElementsAre("7: the mesh `b.stl` is 300 m large, where the model's are 0.4 m"));
  EXPECT_THAT(judged(chainOf(3), {visual("a", 0.3), visual("b", 7.9), visual("c", 0.4)}), IsEmpty())
      << "a large base is no fault";
}

TEST(ModelScale, AllMeshesInMillimetresAreHeldAgainstTheJoints) {
  EXPECT_THAT(judged(chainOf(3), {visual("a", 300, 5), visual("b", 200), visual("c", 400)}),
              ElementsAre("5: the meshes are 300 m large, and the joints reach 1.5 m"));
  EXPECT_THAT(judged(chainOf(3), {visual("a", 1.2), visual("b", 1.0), visual("c", 2)}), IsEmpty());
}

TEST(ModelScale, AllMeshesAThousandTimesTooSmallAreHeldAgainstTheJoints) {
  EXPECT_THAT(
      judged(chainOf(3), {visual("a", 0.0003, 5), visual("b", 0.0002), visual("c", 0.0004)}),
      ElementsAre("5: the joints reach 1.5 m, and the meshes are 0.0003 m large"));
  EXPECT_THAT(judged(chainOf(3), {visual("a", 0.004), visual("b", 0.003), visual("c", 0.005)}),
              IsEmpty())
      << "a thin machine is no fault";
}

TEST(ModelScale, WhatSlidesFarReachesFar) {
  Model gantry = chainOf(3);
  gantry.joints[0].type = JointType::prismatic;
  gantry.joints[0].limits = JointLimits{};
  gantry.joints[0].limits->lower = 0;
  gantry.joints[0].limits->upper = 30;
  EXPECT_THAT(judged(gantry, {visual("a", 40), visual("b", 40), visual("c", 40)}), IsEmpty());
}

TEST(ModelScale, OfTooLittleNothingIsSaid) {
  EXPECT_THAT(judged(chainOf(2), {visual("a", 300), visual("b", 300), visual("c", 300)}), IsEmpty())
      << "two joints say nothing of the machine's size";
  EXPECT_THAT(judged(chainOf(3), {visual("a", 0.1), visual("b", 300)}), IsEmpty())
      << "of two meshes neither is the odd one";
  EXPECT_THAT(judged(chainOf(0), {}), IsEmpty());
}

}  // namespace
}  // namespace rocinante
