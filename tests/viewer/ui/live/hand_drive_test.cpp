#include "viewer/ui/live/hand_drive.h"

#include <gtest/gtest.h>

#include <algorithm>

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

  std::shared_ptr<test::KeptDatagrams::Kept> kept_ = std::make_shared<test::KeptDatagrams::Kept>();
};

TEST_F(Driving, SendsTheJointsAsAnOrdinarySource) {
  HandDrive drive = open();
  const std::vector<double> values{0.5, -1.25};
  drive.set("arm 1", values);
  drive.tick(at(0ns), wall(0ns));
  ASSERT_EQ(kept_->texts.size(), 1U);
  EXPECT_EQ(kept_->texts[0], "RK1 me@run1 0 1700000000\norder arm%201\njoints arm%201 0.5 -1.25\n");
  EXPECT_EQ(drive.devices(), std::vector<std::string>{"arm 1"});
  EXPECT_TRUE(drive.trouble().empty());
}

TEST_F(Driving, AMouseThatMovesAThousandTimesASecondSendsThirtyAndTheLastValue) {
  HandDrive drive = open();
  for (int ms = 0; ms < 1000; ++ms) {
    const std::vector<double> values{ms * 0.001};
    drive.set("arm", values);
    drive.tick(at(ms * 1ms), wall(ms * 1ms));
  }
  drive.tick(at(1100ms), wall(1100ms));
  EXPECT_LE(kept_->texts.size(), 32U);
  EXPECT_GE(kept_->texts.size(), 28U);
  EXPECT_EQ(folded().findDevice("arm")->joints->value, std::vector<double>{0.999});
}

TEST_F(Driving, RestatesForThoseWhoComeLater) {
  HandDrive drive = open();
  const std::vector<double> values{1};
  drive.set("arm", values);
  for (Nanoseconds since = 0ns; since < 5s; since += 50ms) {
    drive.set("arm", values);  // the same again is no news
    drive.tick(at(since), wall(since));
  }
  const auto restated = std::ranges::count_if(kept_->texts, [](const std::string& text) {
    return text.find(" restated ") != std::string::npos;
  });
  EXPECT_GE(restated, 2);
  EXPECT_EQ(static_cast<std::size_t>(restated) + 1, kept_->texts.size());
}

TEST_F(Driving, WhatCannotBeSentIsToldAndMadeUpFor) {
  HandDrive drive = open();
  kept_->refuses = true;
  const std::vector<double> values{1};
  drive.set("arm", values);
  drive.tick(at(0ns), wall(0ns));
  EXPECT_EQ(drive.trouble(), "no route (nowhere)");
  kept_->refuses = false;
  for (Nanoseconds since = 100ms; since < 5s; since += 50ms) drive.tick(at(since), wall(since));
  EXPECT_TRUE(drive.trouble().empty());
  ASSERT_FALSE(kept_->texts.empty());
  EXPECT_EQ(folded().findDevice("arm")->joints->value, values);
  kept_->full = true;
  drive.set("arm", std::vector<double>{2});
  drive.tick(at(6s), wall(6s));
  EXPECT_EQ(drive.trouble(), "the system has no room for more datagrams");
}

TEST_F(Driving, RefusesANameThatNoPacketCanHave) {
  EXPECT_FALSE(HandDrive::into(std::make_unique<test::KeptDatagrams>(kept_), {"", "run"}).ok());
  HandDrive drive = open();
  drive.set("arm", std::vector<double>(2000, 0.123456789));
  EXPECT_NE(drive.trouble().find("arm is not sent"), std::string::npos) << drive.trouble();
}

TEST_F(Driving, ChoosesANewRunAtEachStart) {
  for (int i = 0; i < 2; ++i) {
    HandDrive drive = open({"me", ""});
    drive.set("arm", std::vector<double>{1});
    drive.tick(at(0ns), wall(0ns));
  }
  ASSERT_EQ(kept_->texts.size(), 2U);
  const auto run = [](const std::string& text) { return text.substr(0, text.find(" 0 ")); };
  EXPECT_NE(run(kept_->texts[0]), run(kept_->texts[1]));
}

}  // namespace
}  // namespace rocinante
