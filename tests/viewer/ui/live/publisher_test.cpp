#include "viewer/ui/live/publisher.h"

#include <gtest/gtest.h>

#include "core/packet/decoder.h"
#include "core/session/message_folder.h"
#include "tests/viewer/support/kept_datagrams.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

class Publishes : public testing::Test {
 protected:
  Publisher open(const std::string& name = "ann") {
    auto opened = Publisher::into(std::make_unique<test::KeptDatagrams>(kept_), {name, "r"});
    EXPECT_TRUE(opened.ok());
    return std::move(*opened);
  }
  /// What was sent up to `since` after the start, as one text, and forgets it.
  std::string sentAt(Publisher& publisher, Nanoseconds since) {
    publisher.tick(SteadyTime(since), WallTime(1'700'000'000s + since));
    return take();
  }
  std::string take() {
    std::string all;
    for (const std::string& text : kept_->texts) all += text;
    everything_.insert(everything_.end(), kept_->texts.begin(), kept_->texts.end());
    kept_->texts.clear();
    return all;
  }
  SessionState folded() {
    take();
    SessionState state;
    const auto decoder = makeDecoder("rk1");
    for (const std::string& text : everything_) {
      const Packet* packet = decoder->decode(bytesOf(text));
      EXPECT_NE(packet, nullptr) << text;
      if (packet != nullptr) foldPacket(state, LogTime{}, *packet);
    }
    return state;
  }

  std::shared_ptr<test::KeptDatagrams::Kept> kept_ = std::make_shared<test::KeptDatagrams::Kept>();
  std::vector<std::string> everything_;
};

TEST_F(Publishes, OnlyWhatChangedAsAnOrdinarySource) {
  Publisher ann = open();
  CameraView view{{1, 2, 3}, {0, 0, 0.5}, {0, 0, 1}, 40, {}};
  ann.look(view);
  ann.point(Vec3{1, 0, 0.25});
  EXPECT_EQ(sentAt(ann, 0ns),
            "RK1 ann@r 0 1700000000\n"
            "view ann 1 2 3 0 0 0.5 40\n"
            "points pointer #009e73 size=12 1 0 0.25\n"
            "label pointer-name 1 0 0.25 \"ann\"\n");
  ann.look(view);
  ann.point(Vec3{1, 0, 0.25});
  EXPECT_EQ(sentAt(ann, 100ms), "");  // the same again is no news
  ann.say("look \"here\"");
  EXPECT_EQ(sentAt(ann, 200ms), "RK1 ann@r 1 1700000000.2\nevent \"look \\\"here\\\"\"\n");
  ann.point(std::nullopt);
  EXPECT_EQ(sentAt(ann, 300ms), "RK1 ann@r 2 1700000000.3\nerase pointer\nerase pointer-name\n");
}

TEST_F(Publishes, ThirtyTimesASecondAtMost) {
  Publisher ann = open();
  for (int ms = 0; ms < 1000; ++ms) {
    ann.look({{1.0 + ms, 2, 3}, {0, 0, 0}, {0, 0, 1}, 45, {}});
    ann.tick(SteadyTime(ms * 1ms), WallTime(1'700'000'000s));
  }
  EXPECT_LE(ann.sent(), 31U);
  EXPECT_GE(ann.sent(), 28U);
}

TEST_F(Publishes, DrawnThingsAreReceivedAsTheyAreShownHere) {
  Publisher ann = open();
  ann.addCorner({0, 0, 0}, true);
  ann.addCorner({1, 0, 0}, false);
  ann.addLabel({"arm", "hand", {0, 0, 0.1}}, "worn");
  ann.addCorner({1, 1, 0}, false);  // of the line, although a label came between
  ann.finish(SteadyTime{}, WallTime{});
  SessionState state = folded();
  ASSERT_EQ(ann.drawn().size(), 2U);
  ASSERT_EQ(state.drawings().size(), 2U);
  for (const Publisher::Drawn& drawn : ann.drawn()) {
    const auto found = state.drawings().find({"ann", drawn.id});
    ASSERT_NE(found, state.drawings().end()) << drawn.id;
    EXPECT_EQ(found->second.parts, drawn.drawing.parts);
    EXPECT_EQ(found->second.carrier, drawn.drawing.carrier);
    EXPECT_EQ(found->second.text, drawn.drawing.text);
    EXPECT_EQ(found->second.kind, drawn.drawing.kind);
  }
  EXPECT_EQ(ann.drawn()[0].drawing.parts[0]->size(), 9U);
  ann.eraseDrawn();
  ann.finish(SteadyTime(1s), WallTime{});
  EXPECT_TRUE(folded().drawings().empty());
}

TEST_F(Publishes, ForThoseWhoComeLaterAndLeavesNothingBehind) {
  Publisher ann = open();
  ann.look({});
  ann.point(Vec3{1, 0, 0});
  ann.addLabel({"", "", {0, 0, 0}}, "stays");
  ann.tick(SteadyTime{}, WallTime{});
  take();
  everything_.clear();  // a window that comes now
  for (Nanoseconds since = 50ms; since < 5s; since += 50ms) {
    ann.tick(SteadyTime(since), WallTime(since));
  }
  EXPECT_EQ(folded().views().count("ann"), 1U);
  EXPECT_EQ(folded().drawings().count({"ann", "pointer"}), 1U);
  ann.leave(SteadyTime(5s), WallTime(5s));
  const SessionState left = folded();
  EXPECT_TRUE(left.drawings().empty());
  EXPECT_TRUE(left.views().empty());
}

TEST_F(Publishes, WhatItSaidLastIsHeardBeforeItLeaves) {
  Publisher ann = open();
  ann.look({});
  ann.tick(SteadyTime{}, WallTime{});
  ann.say("bye");
  take();
  ann.leave(SteadyTime(1ms), WallTime(1s));
  EXPECT_EQ(take(),
            "RK1 ann@r 1 1\nevent \"bye\"\n"
            "RK1 ann@r 2 1 restated part=end0:1/1\nRK1 ann@r 3 1 restated part=end1:1/1\n");
}

TEST_F(Publishes, OneOfTheLastDatagramsMayBeLost) {
  for (const int lost : {1, 2}) {
    everything_.clear();
    Publisher ann = open();
    ann.look({});
    ann.addLabel({"", "", {0, 0, 0}}, "worn");
    ann.leave(SteadyTime{}, WallTime{});
    take();
    ASSERT_EQ(everything_.size(), 3U);
    everything_.erase(everything_.begin() + lost);
    EXPECT_TRUE(folded().views().empty());
    EXPECT_TRUE(folded().drawings().empty());
  }
}

TEST_F(Publishes, ALongLineGoesOnInAnother) {
  Publisher ann = open();
  for (int i = 0; i < 150; ++i) ann.addCorner({i * 0.001, 0, 0}, i == 0);
  ASSERT_EQ(ann.drawn().size(), 2U);
  const auto& first = *ann.drawn()[0].drawing.parts[0];
  const auto& second = *ann.drawn()[1].drawing.parts[0];
  EXPECT_EQ(first[first.size() - 3], second[0]);  // without a gap
  EXPECT_TRUE(ann.trouble().empty()) << ann.trouble();
}

TEST_F(Publishes, RefusesWhatNoPacketCanSay) {
  EXPECT_FALSE(Publisher::into(std::make_unique<test::KeptDatagrams>(kept_), {"", "r"}).ok());
  Publisher ann = open();
  ann.say(std::string(5000, 'x'));
  EXPECT_NE(ann.trouble().find("the event is not sent"), std::string::npos) << ann.trouble();
  ann.addLabel({"", "", {0, 0, 0}}, std::string(5000, 'x'));
  EXPECT_TRUE(ann.drawn().empty());
}

}  // namespace
}  // namespace rocinante
