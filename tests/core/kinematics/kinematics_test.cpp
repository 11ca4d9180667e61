#include "core/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/base/hash.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "tests/core/kinematics/model_test_support.h"

namespace rocinante {
namespace {

// A model of one joint between links a and b.
Model oneJoint(const std::string& type, const std::string& inside) {
  const test::ReadUrdf read(
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='" + type +
      "'><parent link='a'/><child link='b'/>" + inside + "</joint></robot>");
  return read.model.value();
}

Vec3 movedPoint(const Model& model, std::vector<double> values, const Vec3& point) {
  JointVector joints = zeroJoints(model);
  joints.values = std::move(values);
  return transformPoint(linkPoses(model, joints)[1], point);
}

void expectNear(const Vec3& got, const Vec3& want) {
  EXPECT_NEAR(got.x, want.x, 1e-14);
  EXPECT_NEAR(got.y, want.y, 1e-14);
  EXPECT_NEAR(got.z, want.z, 1e-14);
}

TEST(Kinematics, EachTypeOfJointMovesItsLink) {
  const std::string at = "<origin xyz='1 0 0' rpy='0 0 1.5707963267948966'/>";
  expectNear(movedPoint(oneJoint("revolute", at + "<axis xyz='0 0 3'/>"), {kPi / 2}, {1, 0, 0}),
             {0, 0, 0});
  expectNear(movedPoint(oneJoint("continuous", at), {kPi / 2}, {0, 1, 0}), {1, 0, 1});
  expectNear(movedPoint(oneJoint("prismatic", at), {2}, {0, 0, 0}), {1, 2, 0});
  expectNear(movedPoint(oneJoint("planar", at), {2, 3, kPi}, {1, 0, 0}), {-2, 1, 0});
  expectNear(movedPoint(oneJoint("floating", at), {1, 2, 3, 0, 0, 2, 0}, {1, 0, 0}), {-1, 0, 3});
  expectNear(movedPoint(oneJoint("floating", ""), {1, 2, 3, 0, 0, 0, 0}, {1, 0, 0}), {2, 2, 3});
  expectNear(movedPoint(oneJoint("fixed", at), {}, {1, 0, 0}), {1, 1, 0});
}

TEST(Kinematics, PlanarJointsHaveTheAxesOfTheirPlane) {
  struct Row {
    const char* normal;
    Vec3 x, y;
  };
  const double root = std::sqrt(0.5);
  for (const Row& row : {Row{"0 0 1", {1, 0, 0}, {0, 1, 0}}, Row{"1 0 0", {0, 1, 0}, {0, 0, 1}},
                         Row{"0 1 0", {0, 0, 1}, {1, 0, 0}}, Row{"0 0 -1", {-1, 0, 0}, {0, 1, 0}},
                         Row{"1 0 1", {root, 0, -root}, {0, 1, 0}}}) {
    SCOPED_TRACE(row.normal);
    const Model model = oneJoint("planar", std::string("<axis xyz='") + row.normal + "'/>");
    expectNear(movedPoint(model, {1, 0, 0}, {0, 0, 0}), row.x);
    expectNear(movedPoint(model, {0, 1, 0}, {0, 0, 0}), row.y);
  }
}

TEST(Kinematics, ValuesAreNamedByJointAndComponent) {
  const test::ReadUrdf read(R"(<robot name="r">
<link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/><link name="f"/>
<joint name="floor" type="planar"><parent link="a"/><child link="b"/></joint>
<joint name="free" type="floating"><parent link="b"/><child link="c"/></joint>
<joint name="floor.x" type="continuous"><parent link="c"/><child link="d"/></joint>
<joint name="held" type="fixed"><parent link="d"/><child link="e"/></joint>
<joint name="follows" type="continuous"><parent link="e"/><child link="f"/><mimic joint="floor.x"/></joint>
</robot>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  const Model& model = *read.model;
  EXPECT_EQ(model.positionalCount(), 11U);
  const auto value = [&](std::string_view name) {
    const auto found = model.findJointValue(name);
    return found ? std::to_string(found->joint) + "." + std::to_string(found->component) : "none";
  };
  EXPECT_EQ(value("floor.yaw"), "0.2");
  EXPECT_EQ(value("free.qw"), "1.6");
  EXPECT_EQ(value("floor.x"), "2.0") << "a joint of that very name comes first";
  for (const char* name : {"floor", "free", "free.yaw", "held", "follows", "other", "free.", ""}) {
    EXPECT_EQ(value(name), "none") << name;
  }
}

TEST(Kinematics, TheHashToldBySendersChangesWithEveryPartOfTheKinematicsAndNothingElse) {
  const std::string inside =
      "<origin xyz='1 2 3'/><axis xyz='0 0 1'/><limit lower='0' upper='1' effort='1' "
      "velocity='1'/>";
  const Model model = oneJoint("revolute", inside);
  EXPECT_EQ(kinematicsHash(model), 0xc6235d03203e0787ULL);

  // The same text, as docs/cell-format.md defines it.
  std::string text = "rocinante kinematics 1\n1:j8:revolute1:a1:b";
  const auto add = [&](double number) {
    for (int shift = 56; shift >= 0; shift -= 8) {
      text += static_cast<char>(std::bit_cast<std::uint64_t>(number) >> shift & 0xFF);
    }
  };
  for (const double number : {1, 2, 3, 0, 0, 0, 1}) add(number);  // origin
  for (const double number : {0, 0, 1}) add(number);              // axis
  text += 'l';
  for (const double number : {0, 1}) add(number);
  text += 'n';  // velocity
  add(1);
  text += 'n';  // effort
  add(1);
  text += '-';  // no mimic
  const auto digest = xxh3(bytesOf(text));
  EXPECT_EQ(hexOf(ByteView(digest).first(8)), "c6235d03203e0787");

  const auto hashOf = [](auto change) {
    Model changed = oneJoint("revolute",
                             "<origin xyz='1 2 3'/><axis xyz='0 0 1'/><limit lower='0' upper='1' "
                             "effort='1' velocity='1'/>");
    change(changed);
    return kinematicsHash(changed);
  };
  const std::uint64_t hash = kinematicsHash(model);
  EXPECT_EQ(hashOf([](Model& m) { m.name = "other"; }), hash);
  EXPECT_EQ(hashOf([](Model& m) { m.joints[0].origin.position.x = 1.0; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].name = "k"; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].type = JointType::continuous; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].axis = {0, 0, -1}; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].origin.position.z += 1e-12; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].limits->upper = 2; }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].limits->effort.reset(); }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.joints[0].limits.reset(); }), hash);
  EXPECT_NE(hashOf([](Model& m) { m.links[1].name = "c"; }), hash);
}

TEST(Kinematics, ALongChainOfMimicsIsFollowedOnce) {
  // Names sorted against the order of the chain, so that each comes before the joint it mimics.
  std::string text = "<robot name='r'><link name='l0'/>";
  const int count = 20000;
  for (int i = 1; i <= count; ++i) text += "<link name='l" + std::to_string(i) + "'/>";
  for (int i = 1; i <= count; ++i) {
    text += "<joint name='j" + std::to_string(i) + "' type='continuous'><parent link='l" +
            std::to_string(i - 1) + "'/><child link='l" + std::to_string(i) + "'/>";
    if (i < count) text += "<mimic joint='j" + std::to_string(i + 1) + "' offset='1'/>";
    text += "</joint>";
  }
  const test::ReadUrdf read(text + "</robot>");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  JointVector joints = zeroJoints(*read.model);
  EXPECT_EQ(joints.values.front(), count - 1);
  joints.values.back() = 1;
  applyMimics(*read.model, joints);
  EXPECT_EQ(joints.values.front(), count);
  EXPECT_EQ(linkPoses(*read.model, joints).size(), static_cast<std::size_t>(count) + 1);
}

}  // namespace
}  // namespace rocinante
