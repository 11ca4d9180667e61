#include "player/demo/demo_script.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

/// From 0 to 1, with speed and acceleration zero at both ends.
double quintic(double fraction) {
  const double u = std::clamp(fraction, 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

double quinticBetween(double seconds, double from, double until) {
  return quintic((seconds - from) / (until - from));
}

/// A move of one value to `target`, at rest before and after.
struct Move {
  double from;
  double until;
  double target;
};

double valueAt(double seconds, double start, std::span<const Move> moves) {
  double value = start;
  for (const Move& move : moves) {
    value += (move.target - value) * quinticBetween(seconds, move.from, move.until);
  }
  return value;
}

constexpr double kHomeX = -0.5;
constexpr double kHomeY = 0.9;
/// Lowered until the gripper's palm is just above the lid.
constexpr double kLoweredAtPallet = kGripperAtZero.z + kCanisterInGripper.z - kCanisterAtPallet.z;
constexpr double kLoweredAtStation = kGripperAtZero.z + kCanisterInGripper.z - kCanisterAtStation.z;

constexpr double kHalfWayX = (kCanisterAtPallet.x + kCanisterAtStation.x) / 2;

constexpr Move kX[] = {{0.5, 2.5, kCanisterAtPallet.x},
                       {6.2, DemoMoment::kWeighed, kHalfWayX},
                       {8.05, 9.55, kCanisterAtStation.x},
                       {12.4, 14.6, kHomeX}};
constexpr Move kY[] = {{0.5, 2.5, kCanisterAtPallet.y}, {12.4, 14.6, kHomeY}};
constexpr Move kZ[] = {{2.4, 4.1, kLoweredAtPallet},
                       {4.95, 6.55, 0.0},
                       {9.3, DemoMoment::kLowered, kLoweredAtStation},
                       {11.5, 12.8, 0.0}};
constexpr Move kGrip[] = {{4.15, DemoMoment::kPicked, kGripHolding},
                          {DemoMoment::kPlaced, 11.5, kGripOpen}};

/// The arm's poses of rest: folded for the gantry's passage, and waiting beside the station.
constexpr ArmJoints kFolded{0.0, -0.80, 1.30, 0.0, 0.95, 0.0};
constexpr ArmJoints kWaiting{-0.62, -0.35, 0.42, 0.0, 1.05, 0.0};
constexpr double kUnfoldBegins = 1.2;
constexpr double kUnfoldEnds = 4.2;
constexpr double kAboveLid = 12.9;
constexpr double kLiftBegins = 17.05;
constexpr double kFoldEnds = 19.4;

/// The trace over the lid: once round along its rim, once round in a spiral to the bung.
constexpr double kBallRadius = 0.008;
constexpr double kLidRecess = 0.012;  ///< depth of the lid below the chime
constexpr double kRimRadius = 0.110;
constexpr double kInnerRadius = 0.055;
constexpr double kApproachHeight = 0.16;
constexpr double kTilt = radiansOf(16);

/// A world point in arm space: the arm is turned half round about z.
Vec3 inArmSpace(const Vec3& world) {
  const Vec3 d = world - kArmBase;
  return {-d.x, -d.y, d.z};
}
Vec3 inWorld(const Vec3& arm) { return kArmBase + Vec3{-arm.x, -arm.y, arm.z}; }

/// The tip over the lid, in arm space: `turns` round the lid from 0 to 2, `height` above it,
/// leaning outwards by `tilt`.
Pose overLid(double turns, double height, double tilt) {
  const Vec3 lid =
      inArmSpace(kCanisterAtStation) + Vec3{0, 0, kCanisterHeight - kLidRecess + kBallRadius};
  const SineCosine around = sineCosine(2 * kPi * turns);
  const double radius =
      kRimRadius + (kInnerRadius - kRimRadius) * quintic(std::max(turns - 1, 0.0));
  const SineCosine lean = sineCosine(tilt);
  const Vec3 outwards{around.cosine, around.sine, 0};
  return Pose{lid + radius * outwards + Vec3{0, 0, height},
              toolPointing(lean.sine * outwards - Vec3{0, 0, lean.cosine})};
}

/// The tip on the straight lines down and up and on the trace between, from kAboveLid to kPathEnds.
Pose tipOverLid(double seconds) {
  const double down = quinticBetween(seconds, kAboveLid, DemoMoment::kTraceBegins);
  const double up = quinticBetween(seconds, kLiftBegins, DemoMoment::kPathEnds);
  const double turns = quinticBetween(seconds, DemoMoment::kTraceBegins, DemoMoment::kMeasured) +
                       quinticBetween(seconds, DemoMoment::kSpiralBegins, DemoMoment::kTraceEnds);
  return overLid(turns, kApproachHeight * (1 - down + up), kTilt * (down - up));
}

ArmJoints jointsOverLid(double seconds) {
  // The lid is well within reach: a test walks the whole path.
  return armJointsFor(tipOverLid(seconds)).value_or(kWaiting);
}

ArmJoints between(const ArmJoints& from, const ArmJoints& to, double fraction) {
  ArmJoints joints{};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i] = from[i] + (to[i] - from[i]) * fraction;
  }
  return joints;
}

/// Simplifies a finely sampled path to a polyline within `tolerance_m`, splitting at the farthest
/// sample.
void simplify(std::span<const Vec3> way, double tolerance_m, std::vector<Vec3>& kept) {
  const Vec3 chord = way.back() - way.front();
  const double chord_squared = glm::dot(chord, chord);
  double worst = 0;
  std::size_t split = 0;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const Vec3 offset = way[i] - way.front();
    const double along =
        chord_squared > 0 ? std::clamp(glm::dot(offset, chord) / chord_squared, 0.0, 1.0) : 0.0;
    const Vec3 across = offset - along * chord;
    const double distance = glm::dot(across, across);
    if (distance > worst) {
      worst = distance;
      split = i;
    }
  }
  if (worst > tolerance_m * tolerance_m) {
    simplify(way.first(split + 1), tolerance_m, kept);
    simplify(way.subspan(split), tolerance_m, kept);
    return;
  }
  kept.push_back(way.back());
}

template <class PointAt>
std::vector<Vec3> sampled(double from, double until, double tolerance_m, PointAt pointAt) {
  constexpr int kSteps = 2000;
  std::vector<Vec3> way;
  for (int i = 0; i <= kSteps; ++i) {
    way.push_back(pointAt(from + (until - from) * i / kSteps));
  }
  std::vector<Vec3> kept{way.front()};
  simplify(way, tolerance_m, kept);
  return kept;
}

}  // namespace

GantryJoints gantryJointsAt(double seconds) {
  return {valueAt(seconds, kHomeX, kX), valueAt(seconds, kHomeY, kY), valueAt(seconds, 0, kZ),
          valueAt(seconds, kGripOpen, kGrip)};
}

ArmJoints armJointsAt(double seconds) {
  if (seconds < DemoMoment::kPathBegins) {
    return between(kFolded, kWaiting, quinticBetween(seconds, kUnfoldBegins, kUnfoldEnds));
  }
  if (seconds < kAboveLid) {
    return between(kWaiting, jointsOverLid(kAboveLid),
                   quinticBetween(seconds, DemoMoment::kPathBegins, kAboveLid));
  }
  if (seconds < DemoMoment::kPathEnds) {
    return jointsOverLid(seconds);
  }
  return between(jointsOverLid(DemoMoment::kPathEnds), kFolded,
                 quinticBetween(seconds, DemoMoment::kPathEnds, kFoldEnds));
}

DemoPath armPath() {
  const auto tipAt = [](double seconds) { return inWorld(armTip(armJointsAt(seconds)).position); };
  DemoPath path;
  path.points = sampled(DemoMoment::kPathBegins, DemoMoment::kPathEnds, 0.0004, tipAt);
  for (const double rest : {DemoMoment::kPathBegins, kAboveLid, DemoMoment::kTraceBegins,
                            DemoMoment::kMeasured, DemoMoment::kTraceEnds, DemoMoment::kPathEnds}) {
    path.waypoints.push_back(tipAt(rest));
  }
  return path;
}

DemoPath carryPath() {
  const auto bottomAt = [](double seconds) {
    const GantryJoints q = gantryJointsAt(seconds);
    return kGripperAtZero + kCanisterInGripper + Vec3{q[0], q[1], -q[2]};
  };
  DemoPath path;
  path.points = sampled(DemoMoment::kPicked, DemoMoment::kPlaced, 0.002, bottomAt);
  path.waypoints = {path.points.front(), path.points.back()};
  return path;
}

}  // namespace rocinante
