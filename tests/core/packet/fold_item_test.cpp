// docs/packet-format.md, section "The fold": the effect of each statement on the items.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "core/packet/joint_order.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::TextFold;
using ::testing::ElementsAre;

class FoldItems : public ::testing::Test {
 protected:
  /// Folds statements of `source`, a second later each time.
  void say(const std::string& source, const std::string& statements) {
    fold_.fold(++second_, "RK1 " + source + " - -\n" + statements);
  }
  const DeviceState& arm() const { return fold_.device("arm"); }
  std::string identity() const { return fold_.state.identityText(); }
  TextFold fold_;
  double second_ = 0;
};

TEST_F(FoldItems, PositionalJointsReplaceAllJointValuesOfTheDevice) {
  say("a", "joints arm 1 2 3\njoint arm grip=4\n");
  EXPECT_THAT(arm().joints->value, ElementsAre(1, 2, 3));
  EXPECT_EQ(arm().named_joints.at("grip").value, 4);
  say("b", "joints arm 5 6\n");
  EXPECT_THAT(arm().joints->value, ElementsAre(5, 6));
  EXPECT_EQ(arm().joints->owner, "b");
  EXPECT_TRUE(arm().named_joints.empty());
}

TEST_F(FoldItems, JointsUnderAKnownOrderAreNamed) {
  say("a", "joints arm 9 9 9\norder arm z y\njoints arm 1 2\n");
  EXPECT_THAT(arm().joints->value, ElementsAre(9, 9, 9));
  EXPECT_EQ(arm().named_joints.at("z").value, 1);
  EXPECT_EQ(arm().named_joints.at("y").value, 2);
}

TEST_F(FoldItems, AnOrderIsItsSourcesAlone) {
  say("a", "order arm z y\n");
  say("b", "joints arm 1 2\n");
  EXPECT_THAT(arm().joints->value, ElementsAre(1, 2));
  EXPECT_TRUE(arm().named_joints.empty());
}

TEST_F(FoldItems, AnOrderWithoutNamesTakesItBack) {
  say("a", "order arm z y\norder arm\njoints arm 1 2\n");
  EXPECT_TRUE(arm().orders.empty());
  EXPECT_THAT(arm().joints->value, ElementsAre(1, 2));
  say("a", "order tank\n");
  EXPECT_EQ(fold_.state.devices().count("tank"), 0U);
}

TEST_F(FoldItems, JointsThatDoNotFitTheirOrderSayNothing) {
  say("a", "order arm z y\njoints arm 1 2\n");
  say("a", "joints arm 1 2 3\n");
  EXPECT_EQ(arm().named_joints.at("z").value, 1);
  EXPECT_FALSE(arm().joints);
  EXPECT_EQ(arm().last_write, test::atSeconds(1));
  const auto& faults = fold_.counts("a").faults;
  EXPECT_EQ(faults[static_cast<std::size_t>(PacketFault::order_mismatch)], 1U);
}

TEST_F(FoldItems, JointsThatNameTheirOrderSayNothingUnderAnother) {
  const std::string tag = fmt::format("@{:08x}", orderTag(std::array<std::string, 2>{"z", "y"}));
  const auto left_out = [&] {
    return fold_.counts("a").faults[static_cast<std::size_t>(PacketFault::unknown_order)];
  };
  // Without an order, under another, and under one of the same names in another order.
  say("a", "joints arm " + tag + " 1 2\n");
  EXPECT_EQ(fold_.state.devices().count("arm"), 0U);
  say("a", "order arm z x\njoints arm " + tag + " 1 2\n");
  say("a", "order arm y z\njoints arm " + tag + " 1 2\n");
  say("a", "order arm z y x\njoints arm " + tag + " 1 2\n");
  EXPECT_TRUE(arm().named_joints.empty());
  EXPECT_EQ(left_out(), 4U);
  // Another source's order is not this one's.
  say("b", "order arm z y\n");
  say("a", "joints arm " + tag + " 1 2\n");
  EXPECT_EQ(left_out(), 5U);
  say("a", "order arm z y\njoints arm " + tag + " 1 2\n");
  EXPECT_EQ(left_out(), 5U);
  EXPECT_EQ(arm().named_joints.at("z").value, 1);
  EXPECT_EQ(arm().named_joints.at("y").value, 2);
  // Too few and too many.
  say("a", "joints arm " + tag + " 5\njoints arm " + tag + " 5 6 7\n");
  EXPECT_EQ(left_out(), 7U);
  say("a", "order arm\njoints arm " + tag + " 5 6\n");
  EXPECT_EQ(left_out(), 8U);
  EXPECT_FALSE(arm().joints);
  EXPECT_EQ(arm().named_joints.at("z").value, 1);
}

TEST(OrderTag, IsTheCrcOfTheNamesAsTheyAreMeant) {
  EXPECT_EQ(orderTag(std::array<std::string, 2>{"shoulder", "elbow"}), 0x09b0af70U);
  EXPECT_NE(orderTag(std::array<std::string, 2>{"ab", "c"}),
            orderTag(std::array<std::string, 2>{"a", "bc"}));
  // A space belongs to a name, a line feed to none.
  EXPECT_NE(orderTag(std::array<std::string, 1>{"a b"}),
            orderTag(std::array<std::string, 2>{"a", "b"}));
}

TEST_F(FoldItems, TheLastToWriteOwns) {
  say("a", "joint arm x=1 y=2\npose arm 0 0 0 0 0 0 1\nshow arm/l\ncolor arm #112233\n");
  say("b", "joint arm x=3\npose arm 1 0 0 0 0 0 1\nhide arm/l\ncolor arm default\n");
  EXPECT_EQ(arm().named_joints.at("x").owner, "b");
  EXPECT_EQ(arm().named_joints.at("y").owner, "a");
  EXPECT_EQ(arm().pose->owner, "b");
  const Path link{false, "arm", "l"};
  EXPECT_EQ(fold_.state.visibility().at(link).owner, "b");
  EXPECT_EQ(fold_.state.visibility().at(link).value.kind, Visibility::Kind::hidden);
  EXPECT_EQ(fold_.state.colors().at(Path{false, "arm", ""}).owner, "b");
}

TEST_F(FoldItems, DefaultIsSaidAndKept) {
  say("a", "color arm #112233\ncolor arm default\nhide layer/x\nshow layer/x default\n");
  EXPECT_EQ(fold_.state.colors().at(Path{false, "arm", ""}).value.rgba, std::nullopt);
  EXPECT_EQ(fold_.state.visibility().at(Path{true, "layer", "x"}).value.kind,
            Visibility::Kind::by_default);
  EXPECT_EQ(fold_.state.devices().count("layer"), 0U);
}

TEST_F(FoldItems, RemoveTakesTheDevicesItemsAndStays) {
  say("a",
      "add arm puma\njoints arm 1\norder arm j\njoint arm j=1\npose arm 0 0 0 0 0 0 1\n"
      "show arm\nhide arm/l\ncolor arm/l #ff0000\nhide arms\nhide layer/arm\n"
      "pose tool 0 0 0 0 0 0 1 in arm/l\nline p #ff0000 in arm/l 0 0 0\n");
  say("b", "order arm k\nremove arm\n");
  EXPECT_EQ(identity(),
            "device arm 2000000000\n"
            "device arms 1000000000\n"
            "device tool 1000000000\n"
            "item a hide arms\n"
            "item a hide layer/arm\n"
            "item a line p #ff0000 in arm/l 0 0 0\n"
            "item a pose tool 0 0 0 0 0 0 1 in arm/l\n"
            "item b remove arm\n"
            "source a - -\n"
            "source b - -\n");
}

TEST_F(FoldItems, StatementsAboutADeviceNotAddedAreKept) {
  say("a", "joints arm 1 2\n");
  say("a", "remove arm\njoints arm 3\n");
  EXPECT_EQ(arm().presence->value.presence, Presence::removed);
  EXPECT_THAT(arm().joints->value, ElementsAre(3));
  say("a", "add arm puma kin=00000000000000ff\n");
  EXPECT_EQ(arm().presence->value.presence, Presence::added);
  EXPECT_EQ(arm().presence->value.model, "puma");
  EXPECT_EQ(arm().presence->value.kinematics, 255U);
  EXPECT_THAT(arm().joints->value, ElementsAre(3));
}

TEST_F(FoldItems, DrawingsAreTheirSourcesAndShareTheirIds) {
  say("a", "line x #ff0000 0 0 0 1 1 1\n");
  say("b", "points x #00ff00 0 0 0\n");
  EXPECT_EQ(fold_.state.drawings().size(), 2U);
  say("a", "label x 1 2 3 \"hi\"\n");
  EXPECT_EQ(fold_.state.drawings().size(), 2U);
  EXPECT_EQ(fold_.state.drawings().at({"a", "x"}).kind, StatementKind::label);
  // A label has no colour; without a default its text would be invisible.
  EXPECT_EQ(fold_.state.drawings().at({"a", "x"}).rgba, 0xFFFFFFFFU);
  EXPECT_EQ(fold_.state.drawings().at({"a", "x"}).text, "hi");
  say("b", "erase x\nerase y\n");
  EXPECT_EQ(fold_.state.drawings().size(), 1U);
  say("b", "line y #ff0000 0 0 0\nline z #ff0000 0 0 0\n");
  say("b", "erase *\n");
  EXPECT_EQ(fold_.state.drawings().size(), 1U);
  EXPECT_EQ(fold_.state.drawings().count({"a", "x"}), 1U);
}

TEST_F(FoldItems, ALongLineComesInPartsAndAMissingOneIsAGap) {
  say("a", "line x:1/3 #ff0000 0 0 0\nline x:3/3 #00ff00 width=2 3 3 3\n");
  const Drawing& line = fold_.state.drawings().at({"a", "x"});
  ASSERT_EQ(line.parts.size(), 3U);
  EXPECT_TRUE(line.parts[0]);
  EXPECT_FALSE(line.parts[1]);
  EXPECT_EQ(line.rgba, 0x00FF00FFU);
  EXPECT_EQ(line.size_px, 2);
  say("a", "line x:2/3 #00ff00 2 2 2\n");
  EXPECT_THAT(*line.parts[1], ElementsAre(2, 2, 2));
  EXPECT_TRUE(line.parts[0] && line.parts[2]);
  say("a", "line x:2/4 #00ff00 2 2 2\n");
  EXPECT_EQ(line.parts.size(), 4U);
  EXPECT_FALSE(line.parts[0]);
  say("a", "points x:1/4 #00ff00 2 2 2\n");
  EXPECT_FALSE(line.parts[1]) << "another kind is another whole";
  EXPECT_EQ(line.size_px, 3) << "points are 3 pixels wide unless said otherwise";
  say("a", "line x #00ff00 2 2 2\n");
  EXPECT_EQ(line.parts.size(), 1U);
  EXPECT_EQ(line.size_px, 1);
}

TEST_F(FoldItems, ViewsAreSharedByName) {
  say("a", "view top 0 0 5 0 0 0 45 up 0 1 0\n");
  say("b", "view top 0 0 6 0 0 0 60 ortho 3 in arm/l\n");
  const Item<ViewValue>& view = fold_.state.views().at("top");
  EXPECT_EQ(view.owner, "b");
  EXPECT_EQ(view.value.eye.z, 6);
  EXPECT_EQ(view.value.up, Vec3(0, 0, 1));
  EXPECT_EQ(view.value.ortho_height_m, 3);
  EXPECT_EQ(view.value.carrier.second, "l");
}

TEST_F(FoldItems, SeenIsBelievedOnlyFromThoseWhoRestateForOthers) {
  say("a", "joints arm 1\nseen arm 7\n");
  EXPECT_EQ(arm().last_write, test::atSeconds(1));
  fold_.fold(5, "RK1 a - - by=k\nseen arm 7\nseen tank 7\n");
  EXPECT_EQ(arm().last_write.time_since_epoch().count(), 7);
  EXPECT_EQ(fold_.state.devices().count("tank"), 0U);
  fold_.fold(5, "RK1 a - - by=k\nseen arm 9000000000000000000\n");
  EXPECT_EQ(arm().last_write, test::atSeconds(5)) << "never in the future";
}

TEST_F(FoldItems, EveryStatementAboutADeviceIsAWrite) {
  say("a", "joints arm 1\n");
  for (const char* const statement : {"joints arm 1", "joint arm a=1", "pose arm 0 0 0 0 0 0 1",
                                      "show arm", "hide arm/l", "color arm #ffffff", "order arm a",
                                      "joints arm 1", "order arm", "add arm m", "remove arm"}) {
    SCOPED_TRACE(statement);
    say("a", statement);
    EXPECT_EQ(arm().last_write, test::atSeconds(second_));
  }
  for (const char* const statement :
       {"pose tool 0 0 0 0 0 0 1 in arm/l", "line l #ffffff in arm/l 0 0 0", "event \"arm\"",
        "view v 0 0 1 0 0 0 45 in arm/l", "show layer/arm"}) {
    SCOPED_TRACE(statement);
    const LogTime before = arm().last_write;
    say("a", statement);
    EXPECT_EQ(arm().last_write, before);
  }
}

TEST_F(FoldItems, StatesAreComparedByWhatWasSaidNotByHowItCame) {
  say("a", "joints arm 1 2\nline x:1/2 #ff0000 0 0 0\n");
  TextFold other;
  other.fold(1, "RK1 a - -\nwave\nline x:1/2 #ff0000 9 9 9\nline x:1/2 #ff0000 0 0 0\n");
  other.fold(1, "RK1 a - -\njoint arm z=1\njoints arm 1 2\nevent \"e\"\n");
  EXPECT_TRUE(fold_.state.sameAs(other.state));
  EXPECT_EQ(fold_.state.identityText(), other.state.identityText());
  other.fold(1.5, "RK1 a - -\njoints arm 1 2\n");
  EXPECT_FALSE(fold_.state.sameAs(other.state)) << "the last write is part of it";
  EXPECT_NE(fold_.state.identityText(), other.state.identityText());
}

}  // namespace
}  // namespace rocinante
