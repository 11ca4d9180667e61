// docs/packet-format.md, section "Limits": bounds on the state that hostile senders cannot pass.
#include <gtest/gtest.h>

#include "core/packet/packet_limits.h"
#include "core/packet/state_weight.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::TextFold;

std::uint64_t tooMany(const TextFold& fold, std::string_view source) {
  return fold.counts(source).faults[static_cast<std::size_t>(PacketFault::too_many)];
}

std::string numbered(const std::string& before, std::size_t count, const std::string& after) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += before + std::to_string(i) + after;
  return text;
}

TEST(StateLimits, DevicesAreBounded) {
  TextFold fold;
  fold.fold(1, "RK1 a - -\n" + numbered("joints d", limits::kDevices + 5, " 1\n"));
  EXPECT_EQ(fold.state.devices().size(), limits::kDevices);
  EXPECT_EQ(tooMany(fold, "a"), 5U);
  fold.fold(2, "RK1 a - -\njoints d0 2\n");
  EXPECT_EQ(fold.device("d0").joints->value[0], 2) << "those that are in go on";
  fold.fold(3, "RK1 a - - part=r:1/1\njoints d0 2\n");
  EXPECT_EQ(fold.state.devices().size(), 1U);
  fold.fold(4, "RK1 a - -\njoints other 2\n");
  EXPECT_EQ(fold.state.devices().size(), 2U) << "and room comes back";
}

TEST(StateLimits, SourcesAreBounded) {
  TextFold fold;
  for (std::size_t i = 0; i < limits::kSources; ++i) {
    ASSERT_EQ(fold.fold(1, "RK1 s" + std::to_string(i) + " 1 -\n"), Applied::yes);
  }
  EXPECT_EQ(fold.fold(1, "RK1 new 1 -\njoints arm 1\n"), Applied::refused);
  EXPECT_TRUE(fold.state.devices().empty());
  EXPECT_EQ(fold.fold(1, "RK1 s0 2 -\njoints arm 1\n"), Applied::yes);
}

TEST(StateLimits, RelaysAreBounded) {
  TextFold fold;
  for (std::size_t i = 0; i < limits::kRelays + 5; ++i) {
    fold.fold(1, "RK1 a - - via=r" + std::to_string(i) + ":1\n");
  }
  EXPECT_EQ(fold.state.relays().size(), limits::kRelays);
}

TEST(StateLimits, DrawingsViewsAndNamedJointsAreBounded) {
  TextFold fold;
  fold.fold(1, "RK1 a - -\n" + numbered("line d", limits::kDrawings + 1, " #ffffff 0 0 0\n"));
  EXPECT_EQ(fold.state.drawings().size(), limits::kDrawings);
  fold.fold(1, "RK1 a - -\n" + numbered("view v", limits::kViews + 1, " 0 0 0 1 1 1 45\n"));
  EXPECT_EQ(fold.state.views().size(), limits::kViews);
  fold.fold(1, "RK1 a - -\n" + numbered("joint d j", limits::kJointValues + 1, "=1\n"));
  EXPECT_EQ(fold.device("d").named_joints.size(), limits::kJointValues);
  EXPECT_EQ(tooMany(fold, "a"), 3U);
}

TEST(StateLimits, SignalsAreBoundedOverAllDevices) {
  TextFold fold;
  const std::size_t half = limits::kSignals / 2;
  fold.fold(1, "RK1 a - -\n" + numbered("signal arm s", half, " 1\n"));
  fold.fold(1, "RK1 a - -\n" + numbered("signal - s", half + 1, " true\n"));
  EXPECT_EQ(fold.state.signals().size(), half);
  EXPECT_EQ(tooMany(fold, "a"), 1U);
  // One that goes makes room for another, and one that is there can change.
  fold.fold(2, "RK1 a - -\nsignal arm s1 default\nsignal - another \"text\"\nsignal - s1 2 V\n");
  EXPECT_EQ(fold.state.signals().size(), half + 1);
  EXPECT_EQ(tooMany(fold, "a"), 1U);
  fold.fold(3, "RK1 a - -\nremove arm\nsignal tray x 1\n");
  EXPECT_EQ(tooMany(fold, "a"), 1U);
}

TEST(StateLimits, EventsNobodyTakesAreBounded) {
  TextFold fold;
  fold.fold(1, "RK1 a - -\n" + numbered("event \"", limits::kEvents + 1, "\"\n"));
  EXPECT_EQ(tooMany(fold, "a"), 1U);
  EXPECT_EQ(fold.state.takeEvents().size(), limits::kEvents);
}

TEST(StateLimits, TheSumOfAllIsBounded) {
  TextFold fold;
  // Each is small on the wire, and claims room for 4,096 parts.
  for (int batch = 0; batch < 3; ++batch) {
    fold.fold(1, "RK1 a - -\n" + numbered("line b" + std::to_string(batch) + "x", 1000,
                                          ":1/4096 #ffffff 0 0 0\n"));
  }
  EXPECT_LE(fold.state.weight(), limits::kStateBytes);
  EXPECT_GT(fold.state.drawings().size(), 1600U);
  EXPECT_LT(fold.state.drawings().size(), 1700U);
  EXPECT_GT(tooMany(fold, "a"), 0U);
  fold.fold(2, "RK1 a - -\nerase *\n");
  EXPECT_LT(fold.state.weight(), 1000U);
}

TEST(StateLimits, TheWeightIsGoneWhenEverythingIs) {
  TextFold fold;
  fold.fold(1, "RK1 a@run 1 -\n");
  const std::uint64_t empty = fold.state.weight();
  EXPECT_EQ(empty, kSourceWeight + 4);
  fold.fold(
      1,
      "RK1 a@run 2 -\nadd arm m\nremove arm\nadd arm mm\njoints arm 1 2\njoint arm a=1\n"
      "joints arm 1 2 3\njoint arm a=1 b=2\norder arm x\norder arm x yy\norder arm2 x\n"
      "order arm2\npose arm 0 0 0 0 0 0 1\npose arm 0 0 0 0 0 0 1 in a/b\nshow arm/l\n"
      "hide arm/l\nshow layer/l\ncolor arm #ffffff\ncolor arm default\nline l:1/3 #ffffff 0 0 0\n"
      "line l:2/3 #ffffff in a/b 0 0 0 1 1 1\nline l:2/4 #ffffff 0 0 0\nlabel t 0 0 0 \"x\"\n"
      "view v 0 0 0 1 1 1 45\nview v 0 0 0 1 1 1 45 in a/b\nerase t\nsignal arm s 1 kg\n"
      "signals arm s=2\nsignal arm s \"text\"\nsignal arm/l s true\nsignal - s 3 N.m\n"
      "signal - t \"longer\"\nsignal - t default\n");
  EXPECT_GT(fold.state.weight(), empty + 1000);
  fold.fold(1, "RK1 a@run 3 - part=r:1/1\n");
  EXPECT_EQ(fold.state.weight(), empty);
  EXPECT_TRUE(fold.state.devices().empty());
  fold.fold(1, "RK1 a@longer 3 -\n");
  EXPECT_EQ(fold.state.weight(), empty + 3);
}

}  // namespace
}  // namespace rocinante
