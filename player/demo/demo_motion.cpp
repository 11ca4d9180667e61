#include "player/demo/demo_motion.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "player/demo/demo_planner.h"
#include "player/demo/demo_script.h"
#include "player/demo/demo_speaker.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kArmPeriod = std::chrono::milliseconds(10);
constexpr Nanoseconds kGantryPeriod = std::chrono::milliseconds(20);
constexpr Nanoseconds kRestatePeriod = std::chrono::seconds(2);
/// The sources start one after the other, as in a real cell: no two datagrams at one moment.
constexpr Nanoseconds kGantryPhase = std::chrono::milliseconds(3);
constexpr std::size_t kLeastMtuBytes = 512;

double motionSeconds(Nanoseconds at) { return static_cast<double>(at.count()) * 1e-9; }

/// Rounds to micrometres and microradians, as an encoder would; short to write.
template <std::size_t N>
std::array<double, N> rounded(std::array<double, N> values) {
  for (double& value : values) {
    value = std::floor(value * 1e6 + 0.5) / 1e6 + 0.0;  // + 0.0: never "-0"
  }
  return values;
}

Statement jointsOf(std::string_view device, std::span<const double> values) {
  Statement statement;
  statement.kind = StatementKind::joints;
  statement.name = device;
  statement.numbers = values;
  return statement;
}

void sayArm(DemoSpeaker& speaker, Nanoseconds start) {
  for (Nanoseconds at{}; at < kDemoLength; at += kArmPeriod) {
    const ArmJoints joints = rounded(armJointsAt(motionSeconds(at)));
    speaker.say(start + at, {jointsOf("arm", joints)});
    if (at.count() > 0 && at % kRestatePeriod == Nanoseconds(0)) {
      speaker.sayAgain(start + at);
    }
  }
}

/// The canister's pose, as the gantry sends it when it changes.
struct CanisterPose {
  PathView carrier;
  std::array<double, 7> numbers;  ///< x y z qx qy qz qw
};

CanisterPose canisterPoseAt(double seconds) {
  const auto upright = [](const Vec3& at) {
    return std::array<double, 7>{at.x, at.y, at.z, 0, 0, 0, 1};
  };
  if (seconds < DemoMoment::kPicked) return {{}, upright(kCanisterAtPallet)};
  if (seconds < DemoMoment::kPlaced) {
    return {PathView{"gantry", "gripper", false}, upright(kCanisterInGripper)};
  }
  return {{}, upright(kCanisterAtStation)};
}

void sayGantry(DemoSpeaker& speaker, Nanoseconds start) {
  constexpr std::string_view kOrder[] = {"x", "y", "z", "grip"};
  Statement order;
  order.kind = StatementKind::order;
  order.name = "gantry";
  order.names = kOrder;

  double before =
      -1;  // time of the last datagram; the canister's pose is sent when it changed since
  for (Nanoseconds at = kGantryPhase; at < kDemoLength; at += kGantryPeriod) {
    const double seconds = motionSeconds(at);
    const GantryJoints joints = rounded(gantryJointsAt(seconds));
    const CanisterPose canister = canisterPoseAt(seconds);
    std::vector<Statement> statements;
    if (before < 0) statements.push_back(order);
    statements.push_back(jointsOf("gantry", joints));
    if (before < 0 || canisterPoseAt(before).numbers != canister.numbers) {
      Statement pose;
      pose.kind = StatementKind::pose;
      pose.name = "canister";
      pose.numbers = canister.numbers;
      pose.carrier = canister.carrier;
      statements.push_back(pose);
    }
    speaker.say(start + at, statements);
    if (at > kGantryPhase && (at - kGantryPhase) % kRestatePeriod == Nanoseconds(0)) {
      speaker.sayAgain(start + at);
    }
    before = seconds;
  }
}

std::vector<DemoDatagram> datagramsOf(DemoPart part, const DemoOptions& options, std::uint64_t turn,
                                      std::uint64_t first_sequence) {
  DemoSpeaker speaker(part, options, first_sequence);
  const Nanoseconds start = static_cast<std::int64_t>(turn) * kDemoLength;
  switch (part) {
    case DemoPart::arm:
      sayArm(speaker, start);
      break;
    case DemoPart::gantry:
      sayGantry(speaker, start);
      break;
    case DemoPart::planner:
      sayPlanner(speaker, start, kRestatePeriod, options.mtu_bytes);
      break;
  }
  return speaker.take();
}

}  // namespace

std::string_view nameOf(DemoPart part) {
  switch (part) {
    case DemoPart::arm:
      return "arm";
    case DemoPart::gantry:
      return "gantry";
    case DemoPart::planner:
      return "planner";
  }
  return "";
}

std::vector<DemoDatagram> demoDatagrams(const std::vector<DemoPart>& parts,
                                        const DemoOptions& options) {
  DemoOptions bounded = options;
  bounded.mtu_bytes = std::max(options.mtu_bytes, kLeastMtuBytes);
  std::vector<DemoDatagram> all;
  for (const DemoPart part : kDemoParts) {
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
    // Every turn has as many datagrams as the first.
    const std::uint64_t before =
        options.turn == 0 ? 0 : options.turn * datagramsOf(part, bounded, 0, 0).size();
    for (DemoDatagram& datagram : datagramsOf(part, bounded, options.turn, before)) {
      all.push_back(std::move(datagram));
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const DemoDatagram& a, const DemoDatagram& b) { return a.at < b.at; });
  return all;
}

}  // namespace rocinante
