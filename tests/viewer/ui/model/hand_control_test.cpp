#include "viewer/ui/model/hand_control.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/kept_datagrams.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/command.h"
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
      std::filesystem::remove(folder_ / "s.mcap");
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
  model.hand.reset(arm.name, "turn");
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
  // Of two commands of one frame, too, the last one is heard.
  const std::vector<std::string> metres = {"m"}, in_style = {"lengths", "mm"};
  ASSERT_TRUE(runCommand("units", metres, stage).ok());
  ASSERT_TRUE(runCommand("style", in_style, stage).ok());
  EXPECT_EQ(model.hand.units.length, LengthUnit::millimetres);
}

TEST_F(MovedByHand, LengthsInThePictureAndInThePanelsHaveOneUnit) {
  ViewModel model = open(false);
  RenderStyle style = model.style();
  style.lengths = LengthUnit::metres;
  model.setStyle(style);
  EXPECT_EQ(model.hand.units.length, LengthUnit::metres);
  EXPECT_EQ(model.frameStyle().lengths, LengthUnit::metres);
  model.hand.units.length = LengthUnit::millimetres;
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  EXPECT_EQ(model.frameStyle().lengths, LengthUnit::millimetres);
  style = model.style();
  style.edges = EdgeStyle::over;
  model.setStyle(style);
  EXPECT_EQ(model.hand.units.length, LengthUnit::millimetres);
}

/// An arm of two joints, and a window that drives it.
class DrivingByHand : public testing::Test {
 protected:
  DrivingByHand() {
    model_.links.resize(3);
    for (std::size_t i = 0; i < 2; ++i) {
      Joint joint;
      joint.name = i == 0 ? "first" : "second";
      joint.type = JointType::continuous;
      joint.parent = i;
      joint.child = i + 1;
      model_.joints.push_back(joint);
      model_.update_order.push_back(i);
    }
    device_.name = "arm";
    device_.model = &model_;
  }
  void drive(HandControl& hand) {
    auto drive = HandDrive::into(std::make_unique<test::KeptDatagrams>(kept_), {"me", "run1"});
    ASSERT_TRUE(drive.ok());
    hand.drive(std::move(*drive));
  }
  /// What is sent within the next seconds: "first=1 second=2", datagram by datagram.
  std::string sentWithin(HandControl& hand, Nanoseconds seconds) {
    kept_->texts.clear();
    for (const SteadyTime until = now_ + seconds; now_ < until; now_ += 20ms) {
      hand.sendDue(now_, WallTime{});
    }
    std::string all;
    for (const std::string& text : kept_->texts) {
      const std::size_t at = text.find("joint arm ");
      all += (all.empty() ? "" : "; ") + (at == std::string::npos ? "-" : text.substr(at + 10));
      if (all.ends_with('\n')) all.pop_back();
    }
    return all;
  }

  Model model_;
  PosedDevice device_;
  SteadyTime now_{};
  std::shared_ptr<test::KeptDatagrams::Kept> kept_ = std::make_shared<test::KeptDatagrams::Kept>();
};

TEST_F(DrivingByHand, InALiveSessionMovesOnlyWhatItDrives) {
  HandControl hand;
  hand.setSituation(true, false);
  EXPECT_FALSE(hand.set(device_, "first", 1));
  drive(hand);
  EXPECT_TRUE(hand.takeEntered());
  EXPECT_FALSE(hand.takeEntered());
  hand.setSituation(true, false);
  EXPECT_EQ(sentWithin(hand, 5s), "") << "nothing was moved";
  ASSERT_TRUE(hand.set(device_, "first", 1));
  // The other joint is not sent, wherever it was last heard.
  EXPECT_FALSE(hand.joints().find("arm", "second"));
  EXPECT_EQ(sentWithin(hand, 5s), "first=1; first=1; first=1");
  const SessionState packets;
  EXPECT_EQ(hand.over(packets, LogTime{}), &packets);
  // Given back is let go: nothing drives to the model's own place.
  hand.reset("arm", "first");
  EXPECT_EQ(sentWithin(hand, 5s), "-");
  EXPECT_FALSE(hand.joints().find("arm", "first"));
  hand.stopDriving();
  hand.setSituation(true, false);
  EXPECT_TRUE(hand.joints().empty());
  EXPECT_FALSE(hand.drive("nonsense", "me"));
  EXPECT_FALSE(hand.drive("127.0.0.1:9", ""));
  EXPECT_FALSE(hand.driveAgain());
  EXPECT_EQ(hand.driving(), nullptr);
}

TEST_F(DrivingByHand, EndsAtOnceWithWhatWasStillToBeSent) {
  HandControl hand;
  drive(hand);
  hand.setSituation(true, false);
  ASSERT_TRUE(hand.set(device_, "first", 1));
  hand.stopDriving();
  EXPECT_EQ(sentWithin(hand, 10s), "");
  hand.setSituation(true, false);
  EXPECT_FALSE(hand.set(device_, "first", 2));
  EXPECT_EQ(sentWithin(hand, 10s), "");
}

TEST_F(DrivingByHand, APlayingLogEndsIt) {
  HandControl hand;
  drive(hand);
  hand.setSituation(false, false);
  ASSERT_TRUE(hand.setAll(device_, std::vector<double>{1, 2}));
  EXPECT_EQ(sentWithin(hand, 100ms), "first=1 second=2");
  hand.setSituation(false, true);
  EXPECT_EQ(hand.driving(), nullptr);
  EXPECT_TRUE(hand.joints().empty());
  EXPECT_EQ(sentWithin(hand, 10s), "");
}

TEST_F(DrivingByHand, WhatWasDrawnOverThePastIsNotSent) {
  HandControl hand;
  hand.setSituation(false, false);
  ASSERT_TRUE(hand.set(device_, "first", 1));
  drive(hand);
  hand.setSituation(true, false);
  EXPECT_TRUE(hand.joints().empty());
  ASSERT_TRUE(hand.set(device_, "second", 2));
  EXPECT_EQ(sentWithin(hand, 1s), "second=2");
}

TEST_F(MovedByHand, EveryKeyThatEndsDrivingEndsIt) {
  for (const char* key : {"escape", "backspace", "N"}) {
    for (const bool with_log : {false, true}) {
      SCOPED_TRACE(key);
      ViewModel model = open(with_log);
      if (with_log) model.cursor()->play(SteadyTime{});
      const auto kept = std::make_shared<test::KeptDatagrams::Kept>();
      auto drive = HandDrive::into(std::make_unique<test::KeptDatagrams>(kept), {"me", "run1"});
      ASSERT_TRUE(drive.ok());
      model.hand.drive(std::move(*drive));
      ASSERT_TRUE(model.update(SteadyTime{}).ok());
      ASSERT_NE(model.hand.driving(), nullptr);
      EXPECT_FALSE(with_log && model.cursor()->playing()) << "entering pauses the log";
      model.selected = {"arm", ""};
      ASSERT_TRUE(model.setByHand("arm", "turn", 0.5, SteadyTime{}));
      ViewerRequests requests;
      const CommandStage stage{model, SteadyTime{}, 480, requests};
      EXPECT_TRUE(runKey(*parseKey(key), stage));
      EXPECT_EQ(model.hand.driving(), nullptr);
      EXPECT_EQ(model.selected.device, "arm") << "and nothing else";
      model.hand.sendDue(SteadyTime(1s), WallTime{});
      EXPECT_TRUE(kept->texts.empty());
    }
  }
}

TEST_F(MovedByHand, ThePlayKeyNeverSends) {
  ViewModel model = open(true);
  const auto kept = std::make_shared<test::KeptDatagrams::Kept>();
  auto drive = HandDrive::into(std::make_unique<test::KeptDatagrams>(kept), {"me", "run1"});
  ASSERT_TRUE(drive.ok());
  model.hand.drive(std::move(*drive));
  ASSERT_TRUE(model.setByHand("arm", "turn", 0.5, SteadyTime{}));
  ViewerRequests requests;
  EXPECT_TRUE(runKey(*parseKey("space"), {model, SteadyTime{}, 480, requests}));
  for (Nanoseconds since = 0ns; since < 3s; since += 20ms) {
    ASSERT_TRUE(model.update(SteadyTime(since)).ok());
    model.hand.sendDue(SteadyTime(since), WallTime{});
  }
  EXPECT_TRUE(kept->texts.empty());
  EXPECT_EQ(model.hand.driving(), nullptr);
}

}  // namespace
}  // namespace rocinante
