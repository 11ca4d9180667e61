#include "viewer/ui/panels/joint_rows.h"

#include <gtest/gtest.h>

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
  EXPECT_FALSE(rows[0].said);
  EXPECT_TRUE(rows[3].mimics);
  EXPECT_DOUBLE_EQ(*rows[1].part(), 0.5);
  EXPECT_FALSE(rows[2].part().has_value());
  EXPECT_TRUE(rows[1].in_radians);
  EXPECT_FALSE(rows[0].in_radians);
}

TEST(JointRows, TellWhereAValueLiesBetweenItsLimits) {
  DeviceState state;
  state.joints = Item<std::vector<double>>{{0.5, 1.5, 9}, "me", {}};
  const auto rows = jointRows(machine(), &state, "");
  EXPECT_TRUE(rows[0].said);
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
  EXPECT_FALSE(rows[0].said);
  EXPECT_EQ(rows[0].value, 0);
}

}  // namespace
}  // namespace rocinante
