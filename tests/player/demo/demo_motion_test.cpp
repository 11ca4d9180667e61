#include "player/demo/demo_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/base/hash.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "player/demo/demo_script.h"

namespace rocinante {
namespace {

const std::vector<DemoPart> kAll(std::begin(kDemoParts), std::end(kDemoParts));

ByteView bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

DemoOptions optionsOf(std::uint64_t turn = 0) {
  DemoOptions options;
  options.epoch_ns = 1'700'000'000'123'456'789;
  options.run = "r1";
  options.turn = turn;
  return options;
}

/// The state after everything up to and including `until`.
SessionState stateAt(const std::vector<DemoDatagram>& datagrams, double until) {
  PacketTextDecoder decoder;
  SessionState state;
  for (const DemoDatagram& datagram : datagrams) {
    if (datagram.at > Nanoseconds(static_cast<std::int64_t>(until * 1e9))) break;
    const Packet* packet = decoder.decode(bytesOf(datagram.payload));
    if (packet != nullptr) state.apply(LogTime(datagram.at), *packet);
  }
  return state;
}

TEST(DemoMotion, EveryDatagramIsAFaultlessPacketWithinTheMtu) {
  PacketTextDecoder decoder;
  for (const std::size_t mtu_bytes : {512U, 700U, 1200U, 60000U}) {
    SCOPED_TRACE(mtu_bytes);
    DemoOptions options = optionsOf();
    options.mtu_bytes = mtu_bytes;
    for (const DemoDatagram& datagram : demoDatagrams(kAll, options)) {
      ASSERT_LE(datagram.payload.size(), mtu_bytes);
      const Packet* packet = decoder.decode(bytesOf(datagram.payload));
      ASSERT_NE(packet, nullptr) << datagram.payload;
      ASSERT_TRUE(packet->faults.empty()) << datagram.payload;
      ASSERT_EQ(packet->header.source, nameOf(datagram.part));
      ASSERT_EQ(packet->header.run, "r1");
      ASSERT_EQ(packet->header.time_ns, options.epoch_ns + datagram.at.count());
    }
  }
}

TEST(DemoMotion, NothingIsLateOrMissingFromTurnToTurn) {
  PacketTextDecoder decoder;
  SessionState state;
  Nanoseconds before{-1};
  for (std::uint64_t turn = 0; turn < 3; ++turn) {
    SCOPED_TRACE(turn);
    const Nanoseconds start = static_cast<std::int64_t>(turn) * kDemoLength;
    for (const DemoDatagram& datagram : demoDatagrams(kAll, optionsOf(turn))) {
      ASSERT_GE(datagram.at, before);
      ASSERT_GE(datagram.at, start);
      ASSERT_LT(datagram.at, start + kDemoLength);
      before = datagram.at;
      ASSERT_EQ(state.apply(LogTime(datagram.at), *decoder.decode(bytesOf(datagram.payload))),
                Applied::yes);
    }
    EXPECT_FALSE(state.restatementOpen());
  }
  for (const DemoPart part : kDemoParts) {
    const SourceCounts& counts = state.counts().at(std::string(nameOf(part)));
    EXPECT_EQ(counts.gap, 0U);
    EXPECT_EQ(counts.late, 0U);
    EXPECT_EQ(counts.restarts, 0U);
  }
}

TEST(DemoMotion, PartsAreTheWholeTakenApart) {
  std::vector<std::string> whole, parts;
  for (const DemoDatagram& datagram : demoDatagrams(kAll, optionsOf(2))) {
    whole.push_back(datagram.payload);
  }
  for (const DemoPart part : kDemoParts) {
    for (const DemoDatagram& datagram : demoDatagrams({part}, optionsOf(2))) {
      EXPECT_EQ(datagram.part, part);
      parts.push_back(datagram.payload);
    }
  }
  EXPECT_EQ(whole.size(), parts.size());
  EXPECT_TRUE(std::is_permutation(whole.begin(), whole.end(), parts.begin()));
}

TEST(DemoMotion, StreamsAtTheRatesOfItsSources) {
  std::map<DemoPart, int> changes;
  PacketTextDecoder decoder;
  for (const DemoDatagram& datagram : demoDatagrams(kAll, optionsOf())) {
    changes[datagram.part] += decoder.decode(bytesOf(datagram.payload))->header.restated ? 0 : 1;
  }
  EXPECT_EQ(changes[DemoPart::arm], 2000);
  EXPECT_EQ(changes[DemoPart::gantry], 1000);
  EXPECT_GT(changes[DemoPart::planner], 10);
}

TEST(DemoMotion, ALateJoinerKnowsAllAfterTwoSeconds) {
  const std::vector<DemoDatagram> datagrams = demoDatagrams(kAll, optionsOf());
  for (const double joined : {0.5, 5.5, 9.9, 13.0, 18.0}) {
    SCOPED_TRACE(joined);
    std::vector<DemoDatagram> heard;
    for (const DemoDatagram& datagram : datagrams) {
      if (datagram.at > Nanoseconds(static_cast<std::int64_t>(joined * 1e9))) {
        heard.push_back(datagram);
      }
    }
    const SessionState late = stateAt(heard, joined + 2.02);
    const SessionState whole = stateAt(datagrams, joined + 2.02);
    EXPECT_EQ(late.identityText(), whole.identityText());
  }
}

TEST(DemoMotion, TheGantryCarriesTheCanisterFromThePalletToTheStation) {
  const std::vector<DemoDatagram> datagrams = demoDatagrams(kAll, optionsOf());
  const auto canisterAt = [&](double seconds) {
    return stateAt(datagrams, seconds).devices().at("canister").pose->value;
  };
  EXPECT_EQ(canisterAt(4.5).carrier.first, "");
  EXPECT_EQ(canisterAt(4.5).pose.position, kCanisterAtPallet);
  EXPECT_EQ(canisterAt(5.1).carrier, (Path{false, "gantry", "gripper"}));
  EXPECT_EQ(canisterAt(5.1).pose.position, kCanisterInGripper);
  EXPECT_EQ(canisterAt(11.2).carrier.first, "");
  EXPECT_EQ(canisterAt(11.2).pose.position, kCanisterAtStation);
}

TEST(DemoMotion, TheCanisterDoesNotJumpWhenItIsTakenOrLeft) {
  const auto heldAt = [](double seconds) {
    const GantryJoints q = gantryJointsAt(seconds);
    return kGripperAtZero + Vec3{q[0], q[1], -q[2]} + kCanisterInGripper;
  };
  EXPECT_LT(glm::length(heldAt(DemoMoment::kPicked) - kCanisterAtPallet), 1e-9);
  EXPECT_LT(glm::length(heldAt(DemoMoment::kPlaced) - kCanisterAtStation), 1e-9);
  EXPECT_NEAR(gantryJointsAt(DemoMoment::kPicked)[3], kGripHolding, 1e-12);
  EXPECT_NEAR(gantryJointsAt(DemoMoment::kPlaced)[3], kGripHolding, 1e-12);
}

TEST(DemoMotion, TellsTwoEvents) {
  PacketTextDecoder decoder;
  SessionState state;
  for (const DemoDatagram& datagram : demoDatagrams(kAll, optionsOf())) {
    state.apply(LogTime(datagram.at), *decoder.decode(bytesOf(datagram.payload)));
  }
  const std::vector<Event> events = state.takeEvents();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].text, "picked");
  EXPECT_EQ(events[1].text, "placed");
  EXPECT_NEAR(static_cast<double>(events[0].time.time_since_epoch().count()) * 1e-9,
              DemoMoment::kPicked, 0.02);
}

/// The joined points of a drawing.
std::vector<Vec3> pointsOf(const Drawing& drawing) {
  std::vector<Vec3> points;
  for (const auto& part : drawing.parts) {
    EXPECT_TRUE(part.has_value());
    if (!part) continue;
    for (std::size_t i = 0; i + 2 < part->size(); i += 3) {
      points.emplace_back((*part)[i], (*part)[i + 1], (*part)[i + 2]);
    }
  }
  return points;
}

double distanceToLine(const Vec3& point, const std::vector<Vec3>& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 chord = line[i + 1] - line[i];
    const double squared = glm::dot(chord, chord);
    const double along =
        squared > 0 ? std::clamp(glm::dot(point - line[i], chord) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(point - line[i] - along * chord));
  }
  return least;
}

TEST(DemoMotion, TheToolFollowsTheDrawnPathWithinAMillimetre) {
  const SessionState state = stateAt(demoDatagrams(kAll, optionsOf()), 10.5);
  const std::vector<Vec3> line = pointsOf(state.drawings().at({"planner", "path"}));
  ASSERT_GT(line.size(), 30U);
  double worst = 0;
  for (double t = DemoMoment::kPathBegins; t <= DemoMoment::kPathEnds; t += 0.005) {
    const Vec3 tip = armTip(armJointsAt(t)).position;
    // The arm is turned half round on its base.
    const Vec3 world = kArmBase + Vec3{-tip.x, -tip.y, tip.z};
    worst = std::max(worst, distanceToLine(world, line));
  }
  EXPECT_LT(worst, 0.001);
}

TEST(DemoMotion, TheBallRollsOnTheLid) {
  const double lid = kCanisterAtStation.z + kCanisterHeight - 0.012;
  for (double t = DemoMoment::kTraceBegins; t <= DemoMoment::kTraceEnds; t += 0.01) {
    SCOPED_TRACE(t);
    const Vec3 tip = armTip(armJointsAt(t)).position;
    EXPECT_NEAR(kArmBase.z + tip.z - 0.008, lid, 1e-9);
    const Vec3 middle = kCanisterAtStation - kArmBase;
    EXPECT_LT(std::hypot(-tip.x - middle.x, -tip.y - middle.y), 0.1101);
  }
}

TEST(DemoMotion, DrawingsComeBeforeTheArmMovesAndAreGoneAtTheEnd) {
  const std::vector<DemoDatagram> datagrams = demoDatagrams(kAll, optionsOf());
  EXPECT_LT(DemoMoment::kPathShown, DemoMoment::kPathBegins);
  EXPECT_TRUE(stateAt(datagrams, 9.5).drawings().contains({"planner", "path"}));
  EXPECT_TRUE(stateAt(datagrams, 18.5).drawings().contains({"planner", "path"}));
  EXPECT_TRUE(stateAt(datagrams, 20).drawings().empty());
  EXPECT_EQ(stateAt(datagrams, 20).views().count("lid"), 1U);
}

TEST(DemoMotion, StandsStillAtTheMomentsThatGoldensTake) {
  const std::vector<DemoDatagram> datagrams = demoDatagrams(kAll, optionsOf());
  const auto itemsAt = [&](double seconds) {
    const SessionState state = stateAt(datagrams, seconds);
    std::string items;
    for (const auto& [name, device] : state.devices()) {
      items += name;
      for (const auto& [joint, value] : device.named_joints) {
        items += joint + std::to_string(value.value);
      }
      if (device.joints) items += ::testing::PrintToString(device.joints->value);
    }
    for (const auto& [id, drawing] : state.drawings()) {
      items += id.second + std::to_string(drawing.rgba);
    }
    return items;
  };
  for (const double begin :
       {0.02, DemoMoment::kPicked + 0.03, DemoMoment::kWeighed + 0.03, DemoMoment::kLowered + 0.03,
        DemoMoment::kMeasured + 0.03, DemoMoment::kErased + 0.03}) {
    SCOPED_TRACE(begin);
    for (const double later : {0.05, 0.1, 0.15, 0.2, 0.25}) {
      EXPECT_EQ(itemsAt(begin + later), itemsAt(begin)) << later;
    }
  }
}

TEST(DemoMotion, MovesWithoutJumps) {
  // Between two samples 1 ms apart nothing exceeds the speed of a real machine; and the motion
  // begins and ends at rest in the same pose of the arm.
  const ArmJoints arm_most{2.0, 2.0, 2.5, 4.0, 4.0, 6.0};
  const GantryJoints gantry_most{3.0, 2.0, 2.0, 0.3};
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const double t = i * 1e-3;
    const ArmJoints a = armJointsAt(t), b = armJointsAt(t + 1e-3);
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_LT(std::abs(b[k] - a[k]) / 1e-3, arm_most[k]) << "joint " << k + 1;
    }
    const GantryJoints g = gantryJointsAt(t), h = gantryJointsAt(t + 1e-3);
    for (std::size_t k = 0; k < g.size(); ++k) {
      ASSERT_LT(std::abs(h[k] - g[k]) / 1e-3, gantry_most[k]) << "gantry joint " << k;
    }
  }
  const ArmJoints first = armJointsAt(0), last = armJointsAt(20);
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_NEAR(last[k], first[k], 1e-12);
  const GantryJoints rest = gantryJointsAt(0), end = gantryJointsAt(20);
  for (std::size_t k = 0; k < rest.size(); ++k) EXPECT_NEAR(end[k], rest[k], 1e-12);
}

}  // namespace
}  // namespace rocinante
