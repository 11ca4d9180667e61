#include "viewer/ui/model/hand_control.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

class MovedByHand : public testing::Test {
 protected:
  ViewModel open(bool with_log) {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    EXPECT_TRUE(cell.ok());
    std::optional<Timeline> session;
    if (with_log) {
      test::writeSession(folder_ / "s.mcap", {{0, "joints arm 0\n"}, {1000, "joints arm 1\n"}});
      session = Timeline::open(folder_ / "s.mcap").value();
    }
    auto model = ViewModel::make(std::move(*cell), std::move(session), std::nullopt, {}, {});
    EXPECT_TRUE(model.ok());
    EXPECT_TRUE(model->update(SteadyTime{}).ok());
    return std::move(*model);
  }
  static double turnOf(const ViewModel& model) {
    const PosedDevice& arm = model.scene().devices[0];
    return jointsOf(*arm.model, model.state().findDevice("arm")).values[0];
  }

  const test::TemporaryFolder folder_;
};

TEST_F(MovedByHand, WithoutALogTheFirstDeviceWithJointsIsThereToBeMoved) {
  ViewModel model = open(false);
  EXPECT_TRUE(model.selected.device.empty());
  EXPECT_EQ(model.inspected().device, "arm");
  ASSERT_TRUE(model.setByHand("arm", "turn", 0.5, SteadyTime{}));
  EXPECT_TRUE(*model.update(SteadyTime{}));
  EXPECT_DOUBLE_EQ(turnOf(model), 0.5);
  EXPECT_FALSE(*model.update(SteadyTime{}));  // at rest again
  const PosedDevice arm = model.scene().devices[0];
  model.hand.reset(arm, "turn");
  EXPECT_TRUE(*model.update(SteadyTime{}));
  EXPECT_DOUBLE_EQ(turnOf(model), 0);
  EXPECT_FALSE(model.setByHand("leg", "turn", 0.5, SteadyTime{}));
  EXPECT_FALSE(model.setByHand("arm", "trun", 0.5, SteadyTime{}));
}

TEST_F(MovedByHand, APausedLogAsksWhatIfAndPlayingEndsIt) {
  ViewModel model = open(true);
  model.cursor()->play(SteadyTime{});
  ASSERT_TRUE(model.setByHand("arm", "turn", 0.25, SteadyTime{}));
  EXPECT_FALSE(model.cursor()->playing());
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  EXPECT_TRUE(model.hand.drawn());
  EXPECT_DOUBLE_EQ(turnOf(model), 0.25);
  EXPECT_DOUBLE_EQ(model.received().findDevice("arm")->joints->value[0], 0);
  // It holds while the person looks at other moments.
  model.cursor()->seek(model.cursor()->end(), SteadyTime{});
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  EXPECT_DOUBLE_EQ(turnOf(model), 0.25);
  EXPECT_DOUBLE_EQ(model.received().findDevice("arm")->joints->value[0], 1);
  model.cursor()->seek(model.cursor()->start(), SteadyTime{});
  model.cursor()->play(SteadyTime{});
  ASSERT_TRUE(model.update(SteadyTime(10ms)).ok());
  EXPECT_FALSE(model.hand.drawn());
  EXPECT_TRUE(model.hand.joints().empty());
  EXPECT_DOUBLE_EQ(turnOf(model), 0);
}

TEST_F(MovedByHand, KeysGiveJointsBackAndSwitchUnits) {
  ViewModel model = open(false);
  ASSERT_TRUE(model.setByHand("arm", "turn", 0.5, SteadyTime{}));
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  EXPECT_TRUE(runKey(*parseKey("backspace"), stage));
  EXPECT_TRUE(model.hand.joints().empty());
  EXPECT_TRUE(runKey(*parseKey("U"), stage));
  EXPECT_EQ(model.hand.units, (Units{AngleUnit::radians, LengthUnit::metres}));
  EXPECT_TRUE(runKey(*parseKey("U"), stage));
  EXPECT_EQ(model.hand.units, Units{});
}

TEST(HandControl, InALiveSessionMovesOnlyWhatItDrives) {
  Model model;
  model.links.resize(3);
  for (std::size_t i = 0; i < 2; ++i) {
    Joint joint;
    joint.name = i == 0 ? "first" : "second";
    joint.type = JointType::continuous;
    joint.parent = i;
    joint.child = i + 1;
    model.joints.push_back(joint);
    model.update_order.push_back(i);
  }
  PosedDevice device;
  device.name = "arm";
  device.model = &model;
  DeviceState received;
  received.joints = Item<std::vector<double>>{{0.1, 0.2}, "robot", {}};
  HandControl hand;
  hand.setSituation(true, false);
  EXPECT_FALSE(hand.set(device, &received, "first", 1));
  ASSERT_TRUE(hand.drive("127.0.0.1:9", "me")) << "discard";
  hand.setSituation(true, false);
  ASSERT_TRUE(hand.set(device, &received, "first", 1));
  // The other joint is held where it was.
  EXPECT_EQ(hand.joints().find("arm", "second"), 0.2);
  const SessionState packets;
  EXPECT_EQ(hand.over(packets, LogTime{}), &packets);
  // Given back is the model's own place: what packets say is what this window sent.
  hand.reset(device, "first");
  EXPECT_EQ(hand.joints().find("arm", "first"), 0.0);
  hand.stopDriving();
  hand.setSituation(true, false);
  EXPECT_TRUE(hand.joints().empty());
  EXPECT_FALSE(hand.drive("nonsense", "me"));
  EXPECT_FALSE(hand.drive("127.0.0.1:9", ""));
  EXPECT_EQ(hand.driving(), nullptr);
}

}  // namespace
}  // namespace rocinante
