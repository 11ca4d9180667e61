#include "core/clearance/clearance_gauge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "core/packet/packet_text.h"
#include "tests/core/clearance/random_bodies.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

constexpr const char* kArm =
    R"(<robot name="arm"><link name="base"/>
<link name="upper"><collision><origin xyz="0.5 0 0"/><geometry><box size="1 0.1 0.1"/></geometry>
</collision></link>
<link name="hand"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
<joint name="a" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
</joint><joint name="b" type="continuous"><parent link="upper"/><child link="hand"/>
<origin xyz="1.2 0 0"/><axis xyz="0 1 0"/></joint></robot>)";
constexpr const char* kBox =
    R"(<robot name="box"><link name="box"><collision><geometry><box size="1 1 1"/></geometry>
</collision></link></robot>)";

class ClearanceGaugeTest : public testing::Test {
 protected:
  ClearanceGaugeTest() {
    test::writeFile(folder_ / "arm.urdf", kArm);
    test::writeFile(folder_ / "box.urdf", kBox);
    std::string text = "format = 1\n";
    for (const char* device : {"arm", "left", "right"}) {
      text += fmt::format("[[device]]\nname = \"{}\"\nmodel = \"{}.urdf\"\n", device,
                          std::string_view(device) == "arm" ? "arm" : "box");
    }
    text +=
        "[[device]]\nname = \"late\"\nmodel = \"box.urdf\"\noptional = true\n"
        "[[clearance]]\nname = \"reach\"\nbetween = [\"arm\", \"*\"]\nmin_m = 0.1\n"
        "[[clearance]]\nname = \"boxes\"\nbetween = [\"left\", \"right\"]\nmin_m = 0\n";
    test::writeFile(folder_ / "cell.toml", text);
    auto cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok());
    for (const Finding& fault : cell->faults) {
      if (fault.rule != "model.no-visual") ADD_FAILURE() << fault.print();
    }
    cell_ = std::move(*cell);
  }

  void say(const std::string& lines) {
    const std::string text = fmt::format("RK1 me {} -\n{}", sequence_, lines);
    const Packet* const packet = decoder_.decode(bytesOf(text));
    ASSERT_NE(packet, nullptr);
    ASSERT_TRUE(packet->faults.empty()) << text;
    state_.apply(LogTime(Nanoseconds(sequence_++)), *packet);
  }

  /// The least of all pairs, one by one.
  std::vector<double> bruteForce(const ClearanceGauge& gauge) {
    const PosedScene scene = poseScene(cell_, state_);
    const CellPlacement now = placementOf(scene, state_);
    BodyStore bodies;
    std::vector<double> least;
    for (const ClearanceGap& gap : gauge.gaps()) {
      double distance = std::numeric_limits<double>::infinity();
      for (const ClearancePair& pair : clearancePairs(cell_, scene, now, bodies).pairs) {
        const PlacedDevice &a = now.devices[pair.a.device], &b = now.devices[pair.b.device];
        if (pair.clearance != gap.clearance || a.name != gap.device_a || b.name != gap.device_b) {
          continue;
        }
        const Mat4 a_in_b = inverseOfRigid(b.link_world[pair.b.link]) * a.link_world[pair.a.link];
        distance = std::min(distance, treeDistance(*pair.body_a, *pair.body_b, a_in_b).distance_m);
      }
      least.push_back(distance);
    }
    return least;
  }

  test::TemporaryFolder folder_;
  Cell cell_;
  PacketTextDecoder decoder_;
  SessionState state_;
  std::uint64_t sequence_ = 0;
};

TEST_F(ClearanceGaugeTest, MeasuresWhatBruteForceDoesInEveryState) {
  test::Random random(3);
  ClearanceGauge gauge(cell_);
  std::vector<double> distances;
  Vec3 left{2, 0, 0}, right{-2, 1, 0};
  Vec3 joints{0, 0, 0};
  for (int i = 0; i < 300; ++i) {
    // Small steps, now and then a jump, and some states in which nothing moves.
    const double size = i % 40 == 0 ? 1.5 : 0.03;
    if (i % 7 != 0) joints += random.point(size);
    if (i % 3 == 0) left += random.point(size);
    if (i % 5 == 0) right += random.point(size);
    say(fmt::format("joints arm {} {}\npose left {} {} {} 0 0 0 1\npose right {} {} {} 0 0 0 1\n",
                    joints.x, joints.y, left.x, left.y, left.z, right.x, right.y, right.z));
    gauge.measure(state_, distances);
    const std::vector<double> expected = bruteForce(gauge);
    ASSERT_EQ(distances.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(distances[k], expected[k]) << "state " << i << ", gap " << k;
    }
  }
}

TEST_F(ClearanceGaugeTest, PlacesLieOnTheSurfaces) {
  ClearanceGauge gauge(cell_);
  std::vector<double> distances;
  test::Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Vec3 left = Vec3{2, 0, 0} + random.point(0.4), right = Vec3{-2, 1, 0} + random.point(0.4);
    say(fmt::format("joints arm {} 0\npose left {} {} {} 0 0 0 1\npose right {} {} {} 0 0 0 1\n",
                    0.1 * i, left.x, left.y, left.z, right.x, right.y, right.z));
    // Some states are measured without asking for places.
    gauge.measure(state_, distances);
    if (i % 3 == 0) continue;
    const std::vector<GapPlace> places = gauge.places(state_);
    ASSERT_EQ(places.size(), distances.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_EQ(places[k].distance_m, distances[k]);
      EXPECT_EQ(places[k].clearance, gauge.gaps()[k].clearance);
      if (distances[k] > 0) {
        EXPECT_NEAR(lengthOf(places[k].on_a - places[k].on_b), distances[k], 1e-9);
      }
    }
    // Of two boxes that are not turned, both ends are on their surfaces.
    const Vec3 off = places.back().on_a - left;
    EXPECT_NEAR(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}), 0.5, 1e-9);
  }
  say("add late late\npose late 0 0 5 0 0 0 1\n");
  EXPECT_EQ(gauge.places(state_).size(), 4U);
  say("remove late\n");
  EXPECT_EQ(gauge.places(state_).size(), 3U) << "without what is not there";
}

TEST_F(ClearanceGaugeTest, WhatIsNotThereHasNoDistance) {
  ClearanceGauge gauge(cell_);
  std::vector<double> distances;
  say("pose left 3 0 0 0 0 0 1\npose right 0 3 0 0 0 0 1\n");
  gauge.measure(state_, distances);
  EXPECT_EQ(distances.size(), 3U);
  say("add late late\npose late 0 0 5 0 0 0 1\n");
  gauge.notice(state_);
  const auto gaps = gauge.gaps();
  ASSERT_EQ(gaps.size(), 4U);
  EXPECT_EQ(gaps[0].device_b, "late");
  gauge.measure(state_, distances);
  ASSERT_EQ(distances.size(), 4U);
  EXPECT_NEAR(distances[0], 4.45, 1e-6) << "from the top of the upper arm";
  EXPECT_NEAR(distances[1], 1.2, 1e-9) << "from the hand to the box on the left";
  say("remove late\n");
  gauge.measure(state_, distances);
  ASSERT_EQ(distances.size(), 4U);
  EXPECT_TRUE(std::isnan(distances[0]));
  EXPECT_TRUE(gauge.unmeasured().empty());
}

TEST_F(ClearanceGaugeTest, OnlyWhatIsChosenIsMeasured) {
  ClearanceGauge gauge(
      cell_, [](std::string_view a, std::string_view b) { return a == "right" || b == "right"; });
  gauge.notice(state_);
  const auto gaps = gauge.gaps();
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].device_b, "right");
  EXPECT_EQ(gaps[1].device_a, "left");
}

TEST(ClearanceFigure, IsRoundedToAHundredthOfAMillimetreAndNeverToZero) {
  EXPECT_EQ(roundedClearance(0), 0);
  EXPECT_EQ(roundedClearance(1e-7), 0.00001);
  EXPECT_EQ(roundedClearance(0.084314), 0.08431);
  EXPECT_EQ(roundedClearance(1.000005), 1.00001);
}

}  // namespace
}  // namespace rocinante
