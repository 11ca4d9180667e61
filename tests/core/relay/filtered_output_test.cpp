#include "core/relay/filtered_output.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/packet/joint_order.h"
#include "tests/core/relay/relay_support.h"

namespace rocinante {
namespace {

using test::itemsAndSources;
using test::RelayedListeners;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

RelayOutputOptions filteredBy(RelayFilter filter) {
  RelayOutputOptions options;
  options.filters.push_back(std::move(filter));
  return options;
}

RelayOutputOptions atMost(double hz) {
  RelayOutputOptions options;
  options.pacing.interval = Nanoseconds(static_cast<std::int64_t>(1e9 / hz));
  return options;
}

TEST(FilteredOutput, PassesTheDevicesAskedForAndNumbersWhatItSends) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm*"}, ~0U}));
  net.receive(1, "RK1 s@a 7 12.5\njoints arm1 1 2\njoints leg 1\nshow leg/l\nhide arm2/l\n");
  net.receive(1, "RK1 s@a 8 12.5\njoints leg 1\n");
  net.receive(1, "RK1 s@a 9 12.5\njoint arm1 a=1 b=2\nevent \"go\"\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s@a 7 12.5 via=site:1:0\njoints arm1 1 2\nhide arm2/l\n",
                          "RK1 s@a 9 12.5 via=site:1:1\nevent \"go\"\njoint arm1 a=1 b=2\n"));
}

TEST(FilteredOutput, PassesSourcesAndKindsOfStatement) {
  RelayedListeners net;
  const auto sources = net.open(filteredBy({{"a"}, {}, ~0U}));
  const auto kinds = net.open(filteredBy({{}, {}, statementKindsOf("joints").value()}));
  net.receive(1, "RK1 a 1 -\npose d 0 0 0 0 0 0 1\norder d j\njoints d 1\n");
  net.receive(1, "RK1 b 1 -\njoints d 2\n");
  EXPECT_THAT(net.listeners[sources].heard,
              ElementsAre("RK1 a 1 - via=site:1:0\norder d j\njoint d j=1\n"
                          "pose d 0 0 0 0 0 0 1\n"));
  EXPECT_THAT(net.listeners[kinds].heard,
              ElementsAre("RK1 a 1 - via=site:2:0\norder d j\njoint d j=1\n",
                          "RK1 b 1 - via=site:2:1\njoints d 2\n"));
}

TEST(FilteredOutput, ConflatesNumbersOfSignalsAndPassesEachState) {
  RelayedListeners net;
  const auto id = net.open(atMost(1));
  for (int i = 0; i < 10; ++i) {
    const std::string n = std::to_string(i);
    const std::string mode = i == 4 ? "\"fault\"" : "\"auto\"";
    net.receive(1 + i * 0.01, "RK1 s@a " + n + " -\nsignal arm mode " + mode +
                                  "\nsignals arm load=" + n +
                                  " busy=" + (i % 2 == 0 ? "true" : "false") + "\n");
  }
  net.passTime(1.9);
  std::string heard;
  for (const std::string& each : net.listeners[id].heard) heard += each;
  EXPECT_THAT(heard, HasSubstr("signal arm mode \"fault\""));
  EXPECT_THAT(heard, HasSubstr("signal arm busy false"));
  EXPECT_THAT(heard, HasSubstr("signal arm load 0\n"));
  EXPECT_THAT(heard, Not(HasSubstr("load 5")));
  net.passTime(2.5);
  EXPECT_EQ(net.listeners[id].fold.state.findSignal("arm", {"", "load"})->value.number, 9);
  net.receive(2.6, "RK1 s@a 10 -\nsignal arm load default\nsignal arm mode default\n");
  EXPECT_EQ(net.listeners[id].fold.state.findSignal("arm", {"", "load"}), nullptr);
  EXPECT_EQ(net.listeners[id].fold.state.findSignal("arm", {"", "mode"}), nullptr);
}

TEST(FilteredOutput, SignalsGoWithTheirDevice) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm"}, ~0U}));
  const auto kinds = net.open(filteredBy({{}, {}, statementKindsOf("signal").value()}));
  net.receive(1,
              "RK1 s@a 1 -\nsignal leg mode \"x\"\nsignals leg load=1\nsignals arm load=2 a=true\n"
              "joints arm 1\nsignal - estop true\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s@a 1 - via=site:1:0\nsignal arm a true\nsignal - estop true\n"
                          "signal arm load 2\njoints arm 1\n"));
  EXPECT_THAT(net.listeners[kinds].heard,
              ElementsAre(testing::AllOf(HasSubstr("signal leg load 1"),
                                         HasSubstr("leg mode \"x\""), Not(HasSubstr("joints")))));
}

TEST(FilteredOutput, PassesSignalsByPatternAndCountsTheOthers) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm"}, ~0U, {"arm lo*", "- estop", "leg load"}}));
  net.receive(1,
              "RK1 s@a 1 -\nsignals arm load=2 a=true b=3\nsignal arm mode \"x\"\n"
              "signal - estop true\nsignal - speed 5\nsignal leg load 1\njoints arm 1\n"
              "signal arm mode default\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s@a 1 - via=site:1:0\nsignal - estop true\nsignal arm load 2\n"
                          "joints arm 1\n"));
  EXPECT_EQ(net.relay.filteredOut(id).stopped, 1U) << "of the leg";
  EXPECT_EQ(net.relay.filteredOut(id).signals, 5U) << "a, b, mode, its default, speed";
  net.passTime(3.5);
  EXPECT_EQ(net.listeners[id].heard.back(),
            "RK1 s@a 1 - restated part=run.1:1/1 by=site via=site:1:1 through=site\n"
            "order arm\njoints arm 1\nsignal arm load 2\nsignal - estop true\n");
}

TEST(FilteredOutput, SmallChangesOfNumbersAreHeldUntilALargerOneOrARestatement) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.pacing.min_change.signals = {{"*", 0.1}, {"arm *.effort", 2}};
  const auto id = net.open(options);
  int sequence = 0;
  // What comes of the statement; empty: it is held.
  const auto after = [&](double seconds, const std::string& statement) {
    const std::size_t before = net.listeners[id].heard.size();
    net.receive(seconds, "RK1 s@a " + std::to_string(sequence++) + " -\n" + statement + '\n');
    const auto& heard = net.listeners[id].heard;
    return heard.size() == before ? "" : heard.back().substr(heard.back().find('\n') + 1);
  };
  EXPECT_EQ(after(1, "signal arm j.effort 10 N.m"), "signal arm j.effort 10 N.m\n");
  EXPECT_EQ(after(1.01, "signals arm j.effort=11.9"), "");
  EXPECT_EQ(after(1.5, "signals arm j.effort=8.1"), "") << "rest does not let it through";
  EXPECT_EQ(after(1.51, "signals arm j.effort=12"), "signal arm j.effort 12 N.m\n");
  EXPECT_EQ(after(1.52, "signal arm j.effort 12 mN.m"), "signal arm j.effort 12 mN.m\n");
  EXPECT_EQ(after(1.53, "signal arm j.effort 12.5 mN.m"), "");
  EXPECT_EQ(after(1.54, "signals arm j.effort=true"), "signal arm j.effort true\n");
  EXPECT_EQ(after(1.55, "signals arm j.effort=true"), "signal arm j.effort true\n");
  EXPECT_EQ(after(1.56, "signals arm j.effort=12.5"), "signal arm j.effort 12.5\n");
  EXPECT_EQ(after(1.57, "signal arm j.effort default"), "signal arm j.effort default\n");
  EXPECT_EQ(after(1.58, "signals arm j.effort=12.5"), "signal arm j.effort 12.5\n");
  EXPECT_EQ(after(1.59, "signals arm other=1"), "signal arm other 1\n");
  EXPECT_EQ(after(1.6, "signals arm other=1.05 j.effort=13"), "");
  EXPECT_EQ(net.relay.filteredOut(id).held, 5U);
  net.passTime(3.5);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
  EXPECT_EQ(after(3.6, "signals arm j.effort=14.9"), "") << "since the restatement";
  EXPECT_EQ(after(3.7, "signals arm j.effort=15"), "signal arm j.effort 15\n");
  net.receive(3.8, "RK1 other@a 0 -\nsignals arm j.effort=15\n");
  EXPECT_THAT(net.listeners[id].heard.back(), HasSubstr("j.effort 15")) << "it has a new owner";
}

TEST(FilteredOutput, SmallChangesCountFromWhatARestatementSaid) {
  RelayedListeners net;
  net.receive(1, "RK1 s@a 0 -\nsignals arm load=1\njoints arm 1\n");
  RelayOutputOptions options;
  options.pacing.min_change = {0.1, 0.1, 0.1, {{"*", 0.1}}};
  const auto id = net.open(options);
  const auto& heard = net.listeners[id].heard;
  net.passTime(4);
  ASSERT_THAT(heard, testing::Contains(HasSubstr("signal arm load 1\n")));
  const auto hearsAt = [&](double seconds, const std::string& packet) {
    const std::size_t before = heard.size();
    net.receive(seconds, packet);
    return heard.size() > before;
  };
  EXPECT_FALSE(hearsAt(4.01, "RK1 s@a 1 -\nsignals arm load=1.05\njoints arm 1.05\n"))
      << "the output was opened after the values";
  EXPECT_TRUE(hearsAt(4.02, "RK1 s@a 2 -\njoints arm 1.11\n"));
  EXPECT_TRUE(hearsAt(4.03, "RK1 s@a 3 -\nsignals arm load=1.11\n"));
}

TEST(FilteredOutput, ASignalThatARestatementForgotIsNoSmallChangeWhenItComesBack) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.pacing.min_change.signals = {{"*", 0.1}};
  const auto id = net.open(options);
  net.receive(1, "RK1 s@a 0 -\nsignals arm load=1 other=1\n");
  net.receive(2, "RK1 s@a 1 - restated part=x:1/1\nsignals arm other=1\n");
  net.passTime(8);
  ASSERT_EQ(net.listeners[id].fold.state.findSignal("arm", {"", "load"}), nullptr);
  net.receive(8.1, "RK1 s@a 2 -\nsignals arm load=1.05\n");
  ASSERT_NE(net.listeners[id].fold.state.findSignal("arm", {"", "load"}), nullptr);
}

TEST(FilteredOutput, ForwardsNoPartAndRestatesByItself) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm"}, ~0U}));
  net.receive(1, "RK1 s 1 - restated part=x:1/1\njoints arm 1\njoints leg 1\n");
  EXPECT_THAT(net.listeners[id].heard, IsEmpty());
  net.passTime(3.5);
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s 1 - restated part=run.1:1/1 by=site via=site:1:0 through=site\n"
                          "order arm\njoints arm 1\n"));
}

TEST(FilteredOutput, TheNewestValueGetsThroughAtMostSoOften) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  for (int i = 0; i <= 100; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) + " " + std::to_string(i) +
                                  "\njoints arm " + std::to_string(i) + "\n");
  }
  net.passTime(2.2);
  const auto& heard = net.listeners[id].heard;
  EXPECT_GE(heard.size(), 10U);
  EXPECT_LE(heard.size(), 12U);
  EXPECT_EQ(heard.back(),
            "RK1 s 100 100 via=site:1:" + std::to_string(heard.size() - 1) + "\njoints arm 100\n");
  EXPECT_EQ(net.relay.conflated(id), 101 - heard.size());
}

TEST(FilteredOutput, CountsWhatANewerValueReplaced) {
  RelayedListeners net;
  const auto whole = net.open();
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints a 1\njoints b 1\ncolor a #ff0000\n");
  EXPECT_EQ(net.relay.conflated(id), 0U);
  // Held once, replaced once; of another device, held only; what is never held.
  net.receive(1.01, "RK1 s 2 -\njoints a 2\n");
  net.receive(1.02, "RK1 s 3 -\njoints a 3\njoints b 2\nevent \"e\"\nerase x\n");
  EXPECT_EQ(net.relay.conflated(id), 1U);
  net.passTime(1.5);
  EXPECT_EQ(net.relay.conflated(id), 1U);
  EXPECT_EQ(net.relay.conflated(whole), 0U);
}

TEST(FilteredOutput, WhatIsHeldWhenTheSourceIsSilentFollowsAsRestated) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints b 1\n");
  net.receive(1.05, "RK1 s 2 -\njoints a 1\njoints b 2\n");
  net.passTime(1.5);
  EXPECT_THAT(
      net.listeners[id].heard,
      ElementsAre("RK1 s 1 - via=site:1:0\njoints b 1\n", "RK1 s 2 - via=site:1:1\njoints a 1\n",
                  "RK1 s 2 - restated by=site via=site:1:2 through=site\njoints b 2\n"));
}

TEST(FilteredOutput, EventsEraseRemoveAndOrderAreNeverHeld) {
  RelayedListeners net;
  const auto id = net.open(atMost(1));
  for (int i = 0; i < 5; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) +
                                  " -\njoints arm 1\nevent \"e\"\nerase x\norder leg a\n"
                                  "remove tray\n");
  }
  const auto& heard = net.listeners[id].heard;
  ASSERT_EQ(heard.size(), 5U);
  EXPECT_EQ(heard[4], "RK1 s 4 - via=site:1:4\nevent \"e\"\nerase x\norder leg a\nremove tray\n");
}

// Without an order a listener takes `joints` as positions, under one as names.
TEST(FilteredOutput, HeldPositionsSurviveAnOrderThatCameAfterThem) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints arm 1 2\n");
  net.receive(1.01, "RK1 s 2 -\njoints arm 3 4\n");
  net.receive(1.02, "RK1 s 3 -\norder arm a b\n");
  net.passTime(1.3);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
  EXPECT_THAT(net.listeners[id].heard.back(),
              HasSubstr("order arm\njoints arm 3 4\norder arm a b"));
}

/// `count` joints of arm, each with the value.
std::string manyJoints(int count, int value) {
  std::string text = "joint arm";
  for (int i = 0; i < count; ++i) text += fmt::format(" a_joint_with_a_name_{:04}={}", i, value);
  return text + '\n';
}

/// Whether the joints of arm at the listener are of one moment.
bool isWhole(const test::TextFold& fold) {
  const auto& joints = fold.device("arm").named_joints;
  return std::ranges::all_of(
      joints, [&](const auto& each) { return each.second.value == joints.begin()->second.value; });
}

TEST(FilteredOutput, ValuesOfADeviceAreTogetherWhateverTheirSize) {
  RelayOutputOptions slow;
  slow.bytes_per_second = 2e6;
  for (const RelayOutputOptions& options : {atMost(100), slow}) {
    SCOPED_TRACE(options.bytes_per_second.has_value());
    RelayedListeners net;
    const auto id = net.open(options);
    auto& listener = net.listeners[id];
    // Restatements and live values: after each datagram.
    std::size_t seen = 0;
    for (int i = 0; i < 300; ++i) {
      net.receive(1 + i * 0.02,
                  fmt::format("RK1 s {} -\n", i) + manyJoints(200, i) + "pose arm 0 0 0 0 0 0 1\n");
      ASSERT_TRUE(isWhole(listener.fold)) << i;
      seen += listener.fold.device("arm").named_joints.size() == 200 ? 1 : 0;
    }
    EXPECT_GE(seen, 290U);
    // Together with the pose.
    EXPECT_TRUE(std::ranges::any_of(listener.heard, [](const std::string& text) {
      return text.find("joint") != text.npos && text.find("\npose arm") != text.npos;
    }));
  }
}

TEST(FilteredOutput, OnlyWhatNoDatagramHoldsIsCut) {
  RelayedListeners net;
  const auto id = net.open(atMost(100));
  for (int part = 0; part < 4; ++part) {
    std::string text = fmt::format("RK1 s {} -\njoint arm", part);
    for (int i = 0; i < 1000; ++i) {
      text += fmt::format(" a_joint_with_a_name_of_{}_and_{:04}=1", part, i);
    }
    net.receive(1.001 + part * 0.001, text + '\n');
  }
  net.passTime(5);
  EXPECT_EQ(net.listeners[id].fold.device("arm").named_joints.size(), 4000U);
  for (const std::string& text : net.listeners[id].heard) EXPECT_LT(text.size(), 65'000U);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

class SlowOutput : public testing::Test {
 protected:
  SlowOutput() {
    RelayOutputOptions slow;
    slow.bytes_per_second = 1e6;
    id_ = net_.open(slow);
  }
  void receive(const std::string& statements) {
    net_.receive(net_.now() + 0.05, fmt::format("RK1 s {} -\n{}", ++sequence_, statements));
  }
  const std::string& last() { return net_.listeners[id_].heard.back(); }
  std::string lastStatements() { return last().substr(last().find('\n') + 1); }
  const DeviceState& arm() { return net_.listeners[id_].fold.device("arm"); }
  std::uint64_t leftOut() {
    return net_.listeners[id_].fold.counts("s").faults[static_cast<std::size_t>(
        PacketFault::unknown_order)];
  }
  static std::string tagOf(std::vector<std::string> names) {
    return fmt::format("@{:08x}", orderTag(names));
  }

  RelayedListeners net_;
  Relay::OutputId id_{};
  int sequence_ = 0;
};

TEST_F(SlowOutput, NamedJointsGoUnderAnOrderThatIsToldOnce) {
  const std::string tag = tagOf({"elbow_joint", "shoulder_joint"});
  receive("joint arm shoulder_joint=1.00004 elbow_joint=2\n");
  EXPECT_EQ(lastStatements(), "order arm elbow_joint shoulder_joint\njoints arm " + tag + " 2 1\n");
  receive("joint arm shoulder_joint=3 elbow_joint=4\n");
  EXPECT_EQ(lastStatements(), "joints arm " + tag + " 4 3\n");
  // One more joint is another order.
  receive("joint arm shoulder_joint=3 elbow_joint=4 wrist_joint=5\n");
  EXPECT_EQ(lastStatements(), "order arm elbow_joint shoulder_joint wrist_joint\njoints arm " +
                                  tagOf({"elbow_joint", "shoulder_joint", "wrist_joint"}) +
                                  " 4 3 5\n");
  // What is shorter by its name has it.
  receive("joint arm wrist_joint=6\n");
  EXPECT_EQ(lastStatements(), "joint arm wrist_joint=6\n");
  EXPECT_EQ(arm().named_joints.at("wrist_joint").value, 6);
  EXPECT_EQ(leftOut(), 0U);
}

TEST_F(SlowOutput, TheOrderIsTheSourcesOwnIfItHasAllJoints) {
  receive("order arm shoulder_joint elbow_joint\njoints arm 1 2\n");
  EXPECT_EQ(lastStatements(), "order arm shoulder_joint elbow_joint\njoints arm " +
                                  tagOf({"shoulder_joint", "elbow_joint"}) + " 1 2\n");
  for (int i = 0; i < 10; ++i) receive("order arm shoulder_joint elbow_joint\njoints arm 3 4\n");
  EXPECT_EQ(lastStatements(), "joints arm " + tagOf({"shoulder_joint", "elbow_joint"}) + " 3 4\n");
  net_.passTime(6);
  EXPECT_EQ(itemsAndSources(net_.listeners[id_].fold.state), itemsAndSources(net_.relay.state()));
}

TEST_F(SlowOutput, PositionsAreNotReadUnderAnOrderThatWasTold) {
  receive("joint arm shoulder_joint=1 elbow_joint=2\n");
  receive("joints arm 7 8\n");
  EXPECT_EQ(lastStatements(), "order arm\njoints arm 7 8\n");
  EXPECT_THAT(arm().joints->value, ElementsAre(7, 8));
  EXPECT_TRUE(arm().named_joints.empty());
  // Both, of one source: by name.
  receive("joints arm 7 9\njoint arm shoulder_joint=1 elbow_joint=2\n");
  EXPECT_EQ(lastStatements(), "joints arm 7 9\njoint arm elbow_joint=2 shoulder_joint=1\n");
  net_.passTime(net_.now() + 5);
  EXPECT_EQ(itemsAndSources(net_.listeners[id_].fold.state), itemsAndSources(net_.relay.state()));
}

TEST_F(SlowOutput, WhoLostTheOrderWaitsForTheRestatement) {
  auto& listener = net_.listeners[id_];
  bool loses = true;
  listener.loses = [&] { return loses; };
  receive("joint arm shoulder_joint=1 elbow_joint=2\n");
  loses = false;
  for (int i = 0; i < 10; ++i) receive("joint arm shoulder_joint=3 elbow_joint=4\n");
  EXPECT_TRUE(arm().named_joints.empty());
  EXPECT_FALSE(arm().joints);
  EXPECT_EQ(leftOut(), 10U);
  net_.passTime(net_.now() + 4);
  EXPECT_EQ(arm().named_joints.at("elbow_joint").value, 4);
  receive("joint arm shoulder_joint=5 elbow_joint=6\n");
  EXPECT_EQ(arm().named_joints.at("elbow_joint").value, 6);
  EXPECT_EQ(leftOut(), 10U);
}

TEST_F(SlowOutput, ARemovedDeviceIsToldItsOrderAgain) {
  receive("joint arm shoulder_joint=1 elbow_joint=2\n");
  receive("remove arm\n");
  receive("add arm ur10\njoint arm shoulder_joint=1 elbow_joint=2\n");
  EXPECT_EQ(leftOut(), 0U);
  EXPECT_EQ(arm().named_joints.size(), 2U);
}

TEST_F(SlowOutput, JointsOfTwoSourcesAreEachUnderTheirOwn) {
  for (int i = 0; i < 50; ++i) {
    net_.receive(net_.now() + 0.05,
                 fmt::format("RK1 s {0} -\njoint arm shoulder_joint={0} elbow_joint={0}\n", i + 1));
    net_.receive(net_.now() + 0.01, fmt::format("RK1 hand {0} -\njoint arm left_finger_joint={0} "
                                                "right_finger_joint={0}\n",
                                                i + 1));
  }
  net_.passTime(net_.now() + 5);
  EXPECT_EQ(leftOut(), 0U);
  EXPECT_EQ(arm().named_joints.at("right_finger_joint").owner, "hand");
  EXPECT_EQ(arm().named_joints.at("elbow_joint").value, 50);
  EXPECT_EQ(arm().orders.size(), 2U);
}

TEST(FilteredOutput, SmallChangesWaitUntilTheDeviceRests) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.pacing.min_change = {0.1, 0.01, 0.1};
  const auto id = net.open(options);
  const auto& heard = net.listeners[id].heard;
  net.receive(1, "RK1 s 0 -\njoints arm 1 1\npose arm 0 0 0 0 0 0 1\n");
  for (int i = 1; i < 10; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) + " -\njoints arm 1 1.0" +
                                  std::to_string(i) + "\npose arm 0 0 0.00" + std::to_string(i) +
                                  " 0 0 0 1\n");
  }
  EXPECT_EQ(heard.size(), 1U);
  net.receive(1.2, "RK1 s 20 -\njoints arm 1 1.2\n");
  EXPECT_EQ(heard.size(), 2U);
  net.receive(1.21, "RK1 s 21 -\njoints arm 1 1.21\n");
  EXPECT_EQ(heard.size(), 2U);
  net.passTime(1.5);
  EXPECT_EQ(heard.size(), 3U);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

TEST(FilteredOutput, AnEventIsInTheSourcesOwnDatagramHoweverSmallTheLink) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.bytes_per_second = 3600;
  const auto id = net.open(options);
  const std::string long_event(300, 'e');
  net.receive(1, "RK1 s 1 -\njoints arm 1\norder leg a\nevent \"" + long_event + "\"\n");
  EXPECT_THAT(net.listeners[id].heard[0], HasSubstr("RK1 s 1 - via=site:1:0\nevent"));
  EXPECT_EQ(net.listeners[id].fold.state.takeEvents().size(), 1U);
}

TEST(FilteredOutput, EraseIsSaidThreeTimesWhereNothingIsForgotten) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.bytes_per_second = 1000;
  const auto id = net.open(options);
  int sequence = 0;
  for (int i = 0; i < 50; ++i) {
    net.receive(1, "RK1 s " + std::to_string(++sequence) + " -\nadd d" + std::to_string(i) +
                       " m\nlabel l" + std::to_string(i % 3) + " 0 0 0 \"x\"\n");
  }
  net.passTime(20);
  // This one is lost, and that one is drawn again.
  net.listeners[id].loses = [] { return true; };
  net.receive(20, "RK1 s " + std::to_string(++sequence) + " -\nerase l1\nerase l2\n");
  net.receive(20, "RK1 s " + std::to_string(++sequence) + " -\nlabel l2 0 0 0 \"new\"\n");
  net.listeners[id].loses = [] { return false; };
  net.passTime(60);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

}  // namespace
}  // namespace rocinante
