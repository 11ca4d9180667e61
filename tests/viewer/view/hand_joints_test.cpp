#include "viewer/view/hand_joints.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/cell/posed_scene.h"
#include "core/packet/decoder.h"
#include "core/session/message_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

/// lift (prismatic, 0 to 2), turn (revolute), finger (mimics lift at half).
constexpr const char* kMachineUrdf = R"(<robot name="machine">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="2" effort="1" velocity="1"/></joint>
  <joint name="turn" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="finger" type="prismatic"><parent link="base"/><child link="c"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="2" effort="1" velocity="1"/><mimic joint="lift" multiplier="0.5"/></joint>
</robot>
)";

class JointsByHand : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "machine.urdf", kMachineUrdf);
    test::writeText(folder_ / "one.toml",
                    "format = 1\n[[device]]\nname = \"m\"\nmodel = \"machine.urdf\"\n");
    test::writeText(folder_ / "two.toml",
                    "format = 1\n[[device]]\nname = \"m 1\"\nmodel = \"machine.urdf\"\n"
                    "[[device]]\nname = \"m2\"\nmodel = \"machine.urdf\"\n"
                    "[[device]]\nname = \"later\"\nmodel = \"machine.urdf\"\noptional = true\n");
    one_ = load("one.toml");
    two_ = load("two.toml");
  }
  Cell load(const char* name) {
    auto cell = loadCell(folder_ / name, {});
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    return cell.ok() ? std::move(*cell) : Cell();
  }
  Vec3 placeOf(const Cell& cell, const SessionState& state, const char* device, const char* link) {
    return Vec3((*poseScene(cell, state).find(device, link))[3]);
  }

  const test::TemporaryFolder folder_;
  Cell one_, two_;
};

TEST_F(JointsByHand, AreFoldedOverWhatPacketsSaidAndMimicJointsFollow) {
  const auto decoder = makeDecoder("rk1");
  SessionState said;
  const Packet* packet = decoder->decode(bytesOf("RK1 robot 7 -\njoints m 0.5 0.25\n"));
  ASSERT_NE(packet, nullptr);
  foldPacket(said, test::sessionTime(5), *packet);
  HandJoints hand;
  ASSERT_TRUE(hand.set("m", *one_.modelOf(one_.devices[0]), "lift", 1.5));
  const SessionState what_if = withHand(said, test::sessionTime(5), hand);
  EXPECT_DOUBLE_EQ(placeOf(one_, what_if, "m", "a").z, 1.5);
  EXPECT_DOUBLE_EQ(placeOf(one_, what_if, "m", "c").x, 0.75);
  // The other joint is as it was said, and what was said is as it was.
  EXPECT_EQ(what_if.findDevice("m")->joints->value, (std::vector<double>{0.5, 0.25}));
  EXPECT_DOUBLE_EQ(placeOf(one_, said, "m", "a").z, 0.5);
}

TEST_F(JointsByHand, ThatAModelHasNotAreRefusedAndNothingIsSet) {
  const Model& model = *one_.modelOf(one_.devices[0]);
  HandJoints hand;
  EXPECT_EQ(hand.set("m", model, "finger", 1).error().what,
            "joint `finger` mimics `lift` and cannot have its own value");
  EXPECT_EQ(hand.set("m", model, "lft", 1).error().what,
            "the model has no joint `lft`; did you mean `lift`?");
  EXPECT_FALSE(hand.set("m", model, "lift", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(hand.setAll("m", model, std::vector<double>{1}).error().what,
            "1 joint value, but the model takes 2: lift turn");
  EXPECT_TRUE(hand.empty());
}

TEST_F(JointsByHand, AreGivenBackOneByOneOrAllOfADevice) {
  const Model& model = *one_.modelOf(one_.devices[0]);
  HandJoints hand;
  ASSERT_TRUE(hand.setAll("m", model, std::vector<double>{1, 0.5}));
  ASSERT_TRUE(hand.set("other", model, "turn", 0.1));
  EXPECT_EQ(hand.count(), 3U);
  hand.reset("m", "lift");
  EXPECT_FALSE(hand.find("m", "lift").has_value());
  EXPECT_EQ(hand.find("m", "turn"), 0.5);
  hand.reset("m", "turn");
  EXPECT_FALSE(hand.devices().contains("m"));
  hand.reset("nobody", "turn");
  hand.reset("other");
  EXPECT_TRUE(hand.empty());
}

TEST_F(JointsByHand, OfAnOptionNameTheirDeviceWhereThereAreSeveral) {
  HandJoints hand;
  ASSERT_TRUE(setJoints(hand, one_, "0.5 -1e-1"));
  EXPECT_EQ(hand.find("m", "turn"), -0.1);
  EXPECT_EQ(setJoints(hand, two_, "0.5 0").error().what,
            "the cell has 3 devices with joints: write DEVICE=VALUES");
  ASSERT_TRUE(setJoints(hand, two_, "m%201=0.5,0"));
  ASSERT_TRUE(setJoints(hand, two_, "m2=1 1"));
  EXPECT_EQ(hand.find("m 1", "lift"), 0.5);
  for (const char* wrong :
       {"m3=1 1", "m2/a=1 1", "*=1 1", "layer/x=1 1", "m2=1", "m2=1 x", "=1 1", "later=1 1"}) {
    EXPECT_FALSE(setJoints(hand, two_, wrong)) << wrong;
  }
}

TEST_F(JointsByHand, AreWrittenAsTheOptionReadsThem) {
  const std::vector<double> values{0.1, -1.0 / 3};
  for (const auto& [cell, device] : {std::pair(&one_, "m"), {&two_, "m 1"}}) {
    const std::string text = jointsText(*cell, device, values);
    HandJoints hand;
    ASSERT_TRUE(setJoints(hand, *cell, text)) << text;
    EXPECT_EQ(hand.find(device, "turn"), values[1]) << text;
  }
  EXPECT_EQ(jointsText(one_, "m", values), "0.1 -0.3333333333333333");
  EXPECT_EQ(jointsText(two_, "m 1", std::vector<double>{1, 2}), "m%201=1 2");
}

}  // namespace
}  // namespace rocinante
