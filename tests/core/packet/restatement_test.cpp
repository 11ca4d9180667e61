#include "core/packet/restatement.h"

#include <gtest/gtest.h>

#include <set>

#include "core/packet/packet_limits.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::TextFold;

RestatementOptions keyframe() {
  RestatementOptions options;
  options.by = "keyframe";
  options.part_id = "k1";
  options.with_seen = true;
  return options;
}

class Restatement : public ::testing::Test {
 protected:
  void say(const std::string& header, const std::string& statements) {
    fold_.fold(++second_, "RK1 " + header + "\n" + statements);
  }
  /// Folding all restatements from nothing must give the identical state.
  void expectKeyframeIsExact(const RestatementOptions& options) const {
    TextFold fresh;
    fresh.foldAll(1000, restateAll(fold_.state, options));
    EXPECT_EQ(fresh.state.identityText(), fold_.state.identityText());
    EXPECT_TRUE(fresh.state.sameAs(fold_.state));
    EXPECT_EQ(fresh.state.weight(), fold_.state.weight());
    EXPECT_FALSE(fresh.state.restatementOpen());
    for (const auto& [name, counts] : fresh.state.counts()) {
      EXPECT_EQ(counts.faults, decltype(counts.faults){}) << name;
    }
  }
  TextFold fold_;
  double second_ = 0;
};

TEST_F(Restatement, IsOrdinaryText) {
  say("sim@7f 41 100.5",
      "add arm puma kin=00ff00ff00ff00ff\norder arm b a\njoints arm 1 2.5\npose arm 1 2 3 0 0 0 1\n"
      "hide arm/l1\ncolor layer/x default\nline p:2/2 #ff0000 width=2 0 0 0\nview v 1 2 3 4 5 6 "
      "45\n");
  const std::vector<std::string> parts = restate(fold_.state, "sim", keyframe());
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0],
            "RK1 sim@7f 41 100.5 restated part=k1:1/1 by=keyframe\n"
            "add arm puma kin=00ff00ff00ff00ff\n"
            "order arm b a\n"
            "pose arm 1 2 3 0 0 0 1\n"
            "joint arm a=2.5 b=1\n"
            "hide arm/l1\n"
            "color layer/x default\n"
            "line p:2/2 #ff0000 width=2 0 0 0\n"
            "view v 1 2 3 4 5 6 45\n"
            "seen arm 1000000000\n");
}

TEST_F(Restatement, ASourceWithNothingToSayHasOneEmptyPart) {
  say("sim@7f 41 100.5", "event \"hello\"\n");
  RestatementOptions options;
  options.by = "player";
  options.part_id = "s";
  options.reset = true;
  EXPECT_EQ(restate(fold_.state, "sim", options),
            std::vector<std::string>{"RK1 sim@7f 41 100.5 restated part=s:1/1 by=player reset\n"});
  EXPECT_EQ(restate(fold_.state, "nobody", options),
            std::vector<std::string>{"RK1 nobody - - restated part=s:1/1 by=player reset\n"});
  expectKeyframeIsExact(keyframe());
}

TEST_F(Restatement, ASourceThatSpeaksForItselfNumbersItsDatagrams) {
  say("sim@7f 41 100.5", "joints a 1\njoints b 2\n");
  RestatementOptions options;
  options.part_id = "s";
  options.mtu_bytes = 80;
  options.first_sequence = 42;
  options.time_ns = 7'000'000'000;
  const auto parts = restate(fold_.state, "sim", options);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0], "RK1 sim@7f 42 7 restated part=s:1/2\norder a\njoints a 1\norder b\n");
  EXPECT_EQ(parts[1], "RK1 sim@7f 43 7 restated part=s:2/2\njoints b 2\n");
}

TEST_F(Restatement, KeepsToTheMtuUnlessOneStatementIsLarger) {
  std::string joints = "joint big";
  for (int i = 0; i < 500; ++i) joints += " joint" + std::to_string(i) + "=0.125";
  std::string line = "line long #ff0000";
  for (int i = 0; i < 300; ++i) line += " 1.5 2.5 3.5";
  say("sim 1 -", joints + '\n' + line + '\n');
  for (int i = 0; i < 100; ++i) say("sim - -", "pose d" + std::to_string(i) + " 1 2 3 0 0 0 1\n");
  const auto parts = restate(fold_.state, "sim", keyframe());
  EXPECT_GT(parts.size(), 8U);
  for (const std::string& part : parts) {
    const bool is_larger_alone = part.find("line long") != std::string::npos;
    EXPECT_LE(part.size(), is_larger_alone ? 4000U : 1200U);
  }
  expectKeyframeIsExact(keyframe());
  RestatementOptions tiny = keyframe();
  tiny.mtu_bytes = 1;
  expectKeyframeIsExact(tiny);
}

TEST_F(Restatement, PositionalJointsUnderAnOrderStayPositional) {
  say("sim 1 -", "joints arm 1 2\norder arm a b\njoint arm c=3\n");
  expectKeyframeIsExact(keyframe());
  // Also for a receiver that already knows the order.
  TextFold receiver;
  receiver.state = fold_.state;
  receiver.foldAll(1000, restateAll(fold_.state, keyframe()));
  EXPECT_TRUE(receiver.state.sameAs(fold_.state));
}

TEST_F(Restatement, WhatClearsOthersItemsComesBeforeThem) {
  // The positions are z's, and a's named joint overrides them.
  say("z 1 -", "joints arm 1 2\n");
  say("a 1 -", "joint arm grip=3\n");
  expectKeyframeIsExact(keyframe());
  // z removed the device; a continued to send about it.
  say("z 2 -", "remove arm\nremove tank\n");
  say("a 2 -", "pose arm 0 0 0 0 0 0 1\njoints arm 7\nhide tank/lid\ncolor tank #ff0000\n");
  say("m 1 -", "joint arm a=1\n");
  expectKeyframeIsExact(keyframe());
  RestatementOptions tiny = keyframe();
  tiny.mtu_bytes = 60;
  expectKeyframeIsExact(tiny);
}

TEST_F(Restatement, SourcesThatOwnItemsOfOneDeviceGoTogetherAlsoByWayOfOthers) {
  using Names = std::set<std::string, std::less<>>;
  say("a 1 -", "joints arm 1\n");
  say("b 1 -", "hide arm/lid\njoint rail x=1\n");
  say("c 1 -", "color rail #ff0000\n");
  say("d 1 -", "joints tray 1\nhide layer/arm\nlabel l in arm/lid 0 0 0 \"x\"\n");
  for (const char* each : {"a", "b", "c"}) {
    EXPECT_EQ(sourcesSharingDevices(fold_.state, each), (Names{"a", "b", "c"})) << each;
  }
  EXPECT_EQ(sourcesSharingDevices(fold_.state, "d"), Names{"d"});
  EXPECT_EQ(sourcesSharingDevices(fold_.state, "nobody"), Names{"nobody"});
}

TEST_F(Restatement, GoingBackwardsGivesTheEarlierState) {
  say("a@1 5 1", "joints arm 1 2\nline p #ff0000 0 0 0\nadd tool t\n");
  say("b 9 -", "joint arm g=1\n");
  const SessionState earlier = fold_.state;
  say("a@2 0 2", "joints arm 3\norder arm x y\njoints arm 4 5\nremove tool\nerase *\n");
  say("b 10 -", "pose arm 1 1 1 0 0 0 1\nhide layer/l\n");
  say("c 1 -", "joints later 1\n");
  RestatementOptions options = keyframe();
  options.reset = true;
  options.by = "player";
  fold_.foldAll(50, restateAll(earlier, options));
  // c is in the log too, but had not sent anything by then.
  fold_.foldAll(50, restate(earlier, "c", options));
  TextFold expected;
  expected.state = earlier;
  expected.fold(50, "RK1 c - - by=player\n");
  EXPECT_EQ(fold_.state.identityText(), expected.state.identityText());
  EXPECT_TRUE(fold_.state.sameAs(expected.state));
}

TEST_F(Restatement, AHugeStateStillFitsItsParts) {
  std::string text = "RK1 sim - -\n";
  for (int i = 0; i < 70000; ++i) text += "hide layer/" + std::to_string(i) + "\n";
  fold_.fold(1, text);
  RestatementOptions options = keyframe();
  options.mtu_bytes = 1;
  EXPECT_LE(restate(fold_.state, "sim", options).size(), limits::kRestatementParts);
  expectKeyframeIsExact(options);
}

}  // namespace
}  // namespace rocinante
