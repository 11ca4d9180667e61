#include "viewer/ui/live/hand_drive.h"

#include <gtest/gtest.h>

#include <optional>

#include "core/packet/decoder.h"
#include "core/session/message_folder.h"
#include "tests/viewer/support/kept_datagrams.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

class Driving : public testing::Test {
 protected:
  HandDrive open(DriveSettings settings = {"me", "run1"}) {
    auto drive = HandDrive::into(std::make_unique<test::KeptDatagrams>(kept_), settings);
    EXPECT_TRUE(drive.ok());
    return std::move(*drive);
  }
  static SteadyTime at(Nanoseconds since) { return SteadyTime(since); }
  static WallTime wall(Nanoseconds since) { return WallTime(1'700'000'000s + since); }
  SessionState folded() const {
    SessionState state;
    const auto decoder = makeDecoder("rk1");
    for (const std::string& text : kept_->texts) {
      const Packet* packet = decoder->decode(bytesOf(text));
      EXPECT_NE(packet, nullptr) << text;
      if (packet != nullptr) foldPacket(state, LogTime{}, *packet);
    }
    return state;
  }
  std::optional<double> turn() const {
    const SessionState state = folded();
    const DeviceState* const arm = state.findDevice("arm");
    if (arm == nullptr || !arm->named_joints.contains("turn")) return std::nullopt;
    return arm->named_joints.at("turn").value;
  }

  std::shared_ptr<test::KeptDatagrams::Kept> kept_ = std::make_shared<test::KeptDatagrams::Kept>();
};

TEST_F(Driving, SendsTheMovedJointsByNameAndNoOther) {
  HandDrive drive = open();
  drive.set("arm 1", "elbow", -1.25);
  drive.tick(at(0ns), wall(0ns));
  ASSERT_EQ(kept_->texts.size(), 1U);
  EXPECT_EQ(kept_->texts[0], "RK1 me@run1 0 1700000000\njoint arm%201 elbow=-1.25\n");
  drive.set("arm 1", "wrist/roll", 0.5);
  drive.tick(at(40ms), wall(40ms));
  ASSERT_EQ(kept_->texts.size(), 2U);
  EXPECT_EQ(kept_->texts[1],
            "RK1 me@run1 1 1700000000.04\njoint arm%201 elbow=-1.25 wrist%2Froll=0.5\n");
  EXPECT_EQ(drive.sent(), 2U);
  EXPECT_TRUE(drive.trouble().empty());
}

TEST_F(Driving, AMouseThatMovesAThousandTimesASecondSendsThirtyAndTheLastValue) {
  HandDrive drive = open();
  for (int ms = 0; ms < 1000; ++ms) {
    drive.set("arm", "turn", ms * 0.001);
    drive.tick(at(ms * 1ms), wall(ms * 1ms));
  }
  drive.tick(at(1100ms), wall(1100ms));
  EXPECT_LE(kept_->texts.size(), 32U);
  EXPECT_GE(kept_->texts.size(), 28U);
  EXPECT_EQ(turn(), 0.999);
}

TEST_F(Driving, RestatesForThoseWhoComeLaterAsLongAsSomethingIsDriven) {
  HandDrive drive = open();
  drive.tick(at(0ns), wall(0ns));
  drive.tick(at(10s), wall(10s));
  EXPECT_TRUE(kept_->texts.empty()) << "nothing was moved";
  const auto run = [&](Nanoseconds from, Nanoseconds until) {
    kept_->texts.clear();
    for (Nanoseconds since = from; since < until; since += 50ms) drive.tick(at(since), wall(since));
  };
  drive.set("arm", "turn", 1);
  run(10s, 15s);
  ASSERT_EQ(kept_->texts.size(), 3U);
  EXPECT_EQ(kept_->texts[1], "RK1 me@run1 1 1700000012 restated part=r0:1/1\njoint arm turn=1\n");
  EXPECT_EQ(turn(), 1);
  drive.set("arm", "turn", 1);  // the same again is no news
  run(15s, 15500ms);
  EXPECT_TRUE(kept_->texts.empty());
}

TEST_F(Driving, WhatIsLetGoIsTakenBackAtOnceAndNeverSentAgain) {
  HandDrive drive = open();
  drive.set("arm", "turn", 1);
  drive.set("arm", "lift", 2);
  drive.tick(at(0ns), wall(0ns));
  drive.release("arm", "turn");
  drive.release("arm", "nothing");
  drive.tick(at(100ms), wall(100ms));
  ASSERT_EQ(kept_->texts.size(), 2U);
  EXPECT_EQ(kept_->texts[1], "RK1 me@run1 1 1700000000.1 restated part=r0:1/1\njoint arm lift=2\n");
  EXPECT_FALSE(turn());
  drive.releaseAll();
  for (Nanoseconds since = 200ms; since < 9s; since += 50ms) drive.tick(at(since), wall(since));
  ASSERT_EQ(kept_->texts.size(), 3U);
  EXPECT_EQ(kept_->texts[2], "RK1 me@run1 2 1700000000.2 restated part=r1:1/1\n");
  EXPECT_EQ(folded().findDevice("arm"), nullptr);
}

TEST_F(Driving, WhatCannotBeSentIsToldAndMadeUpFor) {
  HandDrive drive = open();
  kept_->refuses = true;
  drive.set("arm", "turn", 1);
  drive.tick(at(0ns), wall(0ns));
  EXPECT_EQ(drive.trouble(), "no route (nowhere)");
  kept_->refuses = false;
  for (Nanoseconds since = 100ms; since < 5s; since += 50ms) drive.tick(at(since), wall(since));
  EXPECT_TRUE(drive.trouble().empty());
  EXPECT_EQ(turn(), 1);
  kept_->full = true;
  drive.set("arm", "turn", 2);
  drive.tick(at(6s), wall(6s));
  EXPECT_EQ(drive.trouble(), "the system has no room for more datagrams");
}

TEST_F(Driving, RefusesNamesThatNoPacketCanHave) {
  for (const std::string& name : {std::string(), std::string("a\nb"), std::string(300, 'x'),
                                  std::string("\xff"), std::string(5000, 'x')}) {
    EXPECT_FALSE(HandDrive::into(std::make_unique<test::KeptDatagrams>(kept_), {name, "run"}).ok());
    HandDrive drive = open();
    drive.set("arm", name, 1);
    EXPECT_NE(drive.trouble().find("no packet can hold it"), std::string::npos) << name;
    drive.set(name, "turn", 1);
    drive.tick(at(0ns), wall(0ns));
    EXPECT_TRUE(drive.joints().empty());
  }
  EXPECT_TRUE(kept_->texts.empty());
}

TEST_F(Driving, ChoosesANewRunAtEachStart) {
  for (int i = 0; i < 2; ++i) {
    HandDrive drive = open({"me", ""});
    drive.set("arm", "turn", 1);
    drive.tick(at(0ns), wall(0ns));
  }
  ASSERT_EQ(kept_->texts.size(), 2U);
  const auto run = [](const std::string& text) { return text.substr(0, text.find(" 0 ")); };
  EXPECT_NE(run(kept_->texts[0]), run(kept_->texts[1]));
}

}  // namespace
}  // namespace rocinante
