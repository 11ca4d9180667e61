#include "viewer/shown/joint_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace rocinante {
namespace {

/// lift (prismatic, 0 to 2 m), turn (revolute, -1 to 1), spin (continuous), finger (mimics lift).
Model machine() {
  Model model;
  for (const char* name : {"base", "a", "b", "c", "d"}) {
    Link link;
    link.name = name;
    model.links.push_back(link);
  }
  const auto add = [&](const char* name, JointType type, std::optional<JointLimits> limits) {
    Joint joint;
    joint.name = name;
    joint.type = type;
    joint.parent = model.joints.size();
    joint.child = model.joints.size() + 1;
    joint.limits = limits;
    model.links[joint.child].parent_joint = model.joints.size();
    model.update_order.push_back(model.joints.size());
    model.joints.push_back(joint);
  };
  add("lift", JointType::prismatic, JointLimits{0, 2, {}, {}});
  add("turn", JointType::revolute, JointLimits{-1, 1, {}, {}});
  add("spin", JointType::continuous, std::nullopt);
  add("finger", JointType::prismatic, JointLimits{0, 2, {}, {}});
  model.joints[3].mimic = Mimic{0, 0.5, 0};
  return model;
}

TEST(JointRows, ShowWhatIsDrawnBeforeAnythingWasSaid) {
  const auto rows = jointRows(machine(), nullptr, "");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].name, "lift");
  EXPECT_FALSE(rows[0].is_stated);
  EXPECT_TRUE(rows[3].mimics);
  EXPECT_DOUBLE_EQ(*rows[1].part(), 0.5);
  EXPECT_FALSE(rows[2].part().has_value());
  EXPECT_EQ(rows[1].kind, ValueKind::angle);
  EXPECT_EQ(rows[0].kind, ValueKind::length);
}

TEST(JointRows, TellWhereAValueLiesBetweenItsLimits) {
  DeviceState state;
  state.joints = Item<std::vector<double>>{{0.5, 1.5, 9}, "me", {}};
  const auto rows = jointRows(machine(), &state, "");
  EXPECT_TRUE(rows[0].is_stated);
  EXPECT_DOUBLE_EQ(*rows[0].part(), 0.25);
  EXPECT_FALSE(rows[0].outside());
  EXPECT_DOUBLE_EQ(*rows[1].part(), 1.25);
  EXPECT_TRUE(rows[1].outside());
  EXPECT_DOUBLE_EQ(rows[3].value, 0.25);
}

TEST(JointRows, OfALinkItsOwnJoint) {
  const auto rows = jointRows(machine(), nullptr, "b");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].name, "turn");
  EXPECT_TRUE(jointRows(machine(), nullptr, "base").empty());
}

TEST(JointRows, AWrongCountOfValuesIsAsNothingSaid) {
  DeviceState state;
  state.joints = Item<std::vector<double>>{{0.5}, "me", {}};
  const auto rows = jointRows(machine(), &state, "");
  EXPECT_FALSE(rows[0].is_stated);
  EXPECT_EQ(rows[0].value, 0);
}

TEST(JointRows, TellWhichSourceMovesEachJoint) {
  DeviceState state;
  state.joints = Item<std::vector<double>>{{0.5, 0.5, 0}, "robot", {}};
  state.named_joints["turn"] = Item<double>{0.25, "planner", {}};
  const auto rows = jointRows(machine(), &state, "");
  EXPECT_EQ(rows[0].owner, "robot");
  EXPECT_EQ(rows[1].owner, "planner");
  EXPECT_TRUE(rows[3].owner.empty());  // it follows
  EXPECT_EQ(moversOf(state), "planner, robot");
  EXPECT_EQ(moversOf(DeviceState()), "");
}

TEST(JointRows, SlidersCoverTheLimitsElseATurnElseWhatIncludesTheValue) {
  auto rows = jointRows(machine(), nullptr, "");
  const SliderRange lift = sliderRange(rows[0]);
  EXPECT_DOUBLE_EQ(lift.lower, 0);
  EXPECT_DOUBLE_EQ(lift.valueAt(0.25), 0.5);
  EXPECT_DOUBLE_EQ(lift.partOf(rows[0], 3), 1);
  EXPECT_DOUBLE_EQ(lift.partOf(rows[0], std::nan("")), 0.5);
  const SliderRange spin = sliderRange(rows[2]);
  EXPECT_DOUBLE_EQ(spin.upper, std::numbers::pi);
  // Whole turns do not move the thumb of what turns without end.
  EXPECT_NEAR(spin.partOf(rows[2], 1 + 4 * std::numbers::pi), spin.partOf(rows[2], 1), 1e-12);
  rows[0].lower = rows[0].upper = 0;  // as files without limits have it
  EXPECT_DOUBLE_EQ(sliderRange(rows[0]).upper, 1);
  rows[0].value = -250;
  EXPECT_DOUBLE_EQ(sliderRange(rows[0]).lower, -1000);
  rows[0].value = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(sliderRange(rows[0]).upper, 1e9);
}

}  // namespace
}  // namespace rocinante
