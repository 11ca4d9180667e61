#include "viewer/view/beside_session.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

using test::sessionTime;
using namespace std::chrono_literals;

using Packets = std::vector<std::pair<std::int64_t, std::string>>;

std::string joints(double angle) { return "joints arm " + std::to_string(angle) + "\n"; }

class BesideSessionTest : public testing::Test {
 protected:
  BesideSessionTest() {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    EXPECT_TRUE(cell.ok());
    cell_ = std::move(*cell);
  }
  Timeline session(const std::string& name, const Packets& packets) {
    std::filesystem::remove(folder_ / name);
    test::writeSession(folder_ / name, packets);
    auto opened = Timeline::open(folder_ / name);
    EXPECT_TRUE(opened.ok());
    return std::move(*opened);
  }
  Result<EventAlignment> align(std::string_view how, Timeline& shown, Timeline& beside) {
    StateDamage damage;
    return alignBeside(how, shown, beside, damage);
  }
  /// The names of a scene's devices with those beside.
  std::vector<std::string> shownWith(BesideSession& beside, Timeline& shown, LogTime moment) {
    const auto state = shown.stateAt(moment);
    EXPECT_TRUE(state.ok());
    PosedScene scene = poseScene(cell_, **state);
    StateDamage damage;
    EXPECT_TRUE(beside.addGhosts(scene, moment, damage).ok());
    std::vector<std::string> names;
    for (const PosedDevice& device : scene.devices) {
      names.push_back(device.name);
      EXPECT_EQ(scene.findDevice(device.name), &scene.devices[names.size() - 1]);
      EXPECT_EQ(device.ghost, names.size() > 1);
    }
    return names;
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(BesideSessionTest, OnlyWhatIsElsewhereIsAGhost) {
  Timeline shown = session("a.mcap", {{0, joints(0)}, {1000, joints(1)}, {2000, joints(2)}});
  // A tenth of the limit off, then a degree.
  Timeline other =
      session("b.mcap", {{0, joints(0.0000875)}, {1000, joints(1.0175)}, {2000, joints(2)}});
  auto alignment = align("origin", shown, other);
  ASSERT_TRUE(alignment.ok());
  BesideSession beside(cell_, std::move(other), std::move(*alignment));
  using Names = std::vector<std::string>;
  EXPECT_EQ(shownWith(beside, shown, sessionTime(500)), (Names{"arm"}));
  EXPECT_EQ(shownWith(beside, shown, sessionTime(1500)), (Names{"arm", "beside:arm"}));
  EXPECT_EQ(shownWith(beside, shown, sessionTime(2000)), (Names{"arm"}));
}

TEST_F(BesideSessionTest, NothingIsShownOfAMomentThatItDoesNotHave) {
  Timeline shown = session("a.mcap", {{0, joints(0)}, {5000, joints(1)}});
  Timeline other = session("b.mcap", {{0, joints(2)}, {1000, joints(2)}});
  auto alignment = align("-2s", shown, other);
  ASSERT_TRUE(alignment.ok());
  BesideSession beside(cell_, std::move(other), std::move(*alignment));
  EXPECT_FALSE(beside.covers(sessionTime(1999)));
  EXPECT_TRUE(beside.covers(sessionTime(2000)));
  EXPECT_TRUE(beside.covers(sessionTime(3000)));
  EXPECT_FALSE(beside.covers(sessionTime(3001)));
  EXPECT_EQ(shownWith(beside, shown, sessionTime(1999)).size(), 1U);
  EXPECT_EQ(shownWith(beside, shown, sessionTime(2000)).size(), 2U);
}

TEST_F(BesideSessionTest, IsAlignedByOriginEventsOneEventOrAnOffset) {
  Timeline shown = session("a.mcap", {{0, joints(0) + "event \"ready\"\n"},
                                      {1000, "event \"grasped\"\n"},
                                      {4000, "event \"placed\"\n"}});
  Timeline other = session("b.mcap", {{0, joints(0) + "event \"ready\"\n"},
                                      {2000, "event \"grasped\"\n"},
                                      {8000, "event \"placed\"\n"}});
  const auto at = [&](std::string_view how, std::int64_t ms) {
    const auto alignment = align(how, shown, other);
    EXPECT_TRUE(alignment.ok()) << alignment.error().text();
    return (alignment->inB(sessionTime(ms)) - sessionTime(0)).count() / 1'000'000;
  };
  EXPECT_EQ(at("", 500), 500);
  EXPECT_EQ(at("origin", 500), 500);
  EXPECT_EQ(at("250ms", 500), 750);
  EXPECT_EQ(at("event:grasped", 500), 1500);
  EXPECT_EQ(at("events", 500), 1000);
  EXPECT_EQ(at("events", 2500), 5000);
}

TEST_F(BesideSessionTest, WhatAlignsNothingIsASentence) {
  Timeline shown = session("a.mcap", {{0, joints(0) + "event \"ready\"\n"}, {1000, joints(1)}});
  Timeline other = session("b.mcap", {{0, joints(0) + "event \"steady\"\n"}, {1000, joints(1)}});
  EXPECT_EQ(align("middle", shown, other).error().what,
            "`middle` aligns nothing: use origin, events, event:TEXT or an offset, as 2.5s");
  EXPECT_EQ(align("events", shown, other).error().what, "the two sessions have no event in common");
  const Error missing = align("event:ready", shown, other).error();
  EXPECT_EQ(missing.what, "no event is called `ready`");
  EXPECT_EQ(missing.where, (folder_ / "b.mcap").string());
}

TEST_F(BesideSessionTest, AFrameShowsAGhostWhereTheTwoAreApart) {
  Timeline shown = session("a.mcap", {{0, joints(0)}, {1000, joints(0)}, {2000, joints(0)}});
  FrameRequest request;
  request.width = 160;
  request.height = 120;
  request.camera = "@0,0,6/0,0,0/up=0,1,0";
  const auto drawn = [&](std::optional<Packets> packets, std::int64_t ms,
                         std::vector<std::string> hide = {}) {
    auto opened = Timeline::open(folder_ / "a.mcap");
    auto maker = FrameMaker::open(cell_, std::move(*opened), Profile::reproducible);
    EXPECT_TRUE(maker.ok()) << maker.error().text();
    if (packets) {
      Timeline other = session("b.mcap", *packets);
      auto alignment = align("origin", *maker->session(), other);
      maker->showBeside(std::move(other), std::move(*alignment));
    }
    request.time = sessionTime(ms);
    request.hide = std::move(hide);
    auto picture = maker->frame(request);
    EXPECT_TRUE(picture.ok()) << picture.error().text();
    return std::move(*picture);
  };
  const Packets apart{{0, joints(0)}, {1000, joints(1.57)}, {2000, joints(0)}};
  const Picture alone = drawn(std::nullopt, 1500);
  EXPECT_EQ(drawn(apart, 500).rgba, alone.rgba);
  EXPECT_EQ(drawn(apart, 2000).rgba, alone.rgba);
  EXPECT_EQ(drawn(apart, 1500, {"beside:arm"}).rgba, alone.rgba);
  const Picture both = drawn(apart, 1500);
  ASSERT_NE(both.rgba, alone.rgba);
  // The hand itself, to the right, is as it was; its ghost is above the middle.
  const auto pixel = [&](const Picture& picture, int x, int y) {
    return std::vector<std::uint8_t>(picture.rgba.begin() + (y * 160 + x) * 4,
                                     picture.rgba.begin() + (y * 160 + x) * 4 + 3);
  };
  EXPECT_EQ(pixel(both, 106, 60), pixel(alone, 106, 60));
  EXPECT_NE(pixel(both, 80, 34), pixel(alone, 80, 34));
}

}  // namespace
}  // namespace rocinante
