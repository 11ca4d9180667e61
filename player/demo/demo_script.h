#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/math/vector.h"
#include "player/demo/demo_arm.h"

namespace rocinante {

/// The demo's motion as functions of time: seconds after its zero, clamped to its ends. Metres,
/// radians; world space unless stated otherwise. The positions repeat those of examples/demo.

/// Joint values of the gantry: x, y (bridge, trolley), z (hoist, downwards), grip (closing).
using GantryJoints = std::array<double, 4>;
GantryJoints gantryJointsAt(double seconds);
ArmJoints armJointsAt(double seconds);

/// The centre of the canister's bottom while nothing carries it; upright.
inline constexpr Vec3 kCanisterAtPallet{-2.4, -1.0, 0.25};
inline constexpr Vec3 kCanisterAtStation{1.25, -1.0, 0.55};
inline constexpr double kCanisterHeight = 0.50;
/// The canister's bottom in the space of gantry/gripper while held.
inline constexpr Vec3 kCanisterInGripper{0, 0, -0.54};
/// The position of gantry/gripper with all joints at zero.
inline constexpr Vec3 kGripperAtZero{0, 0, 2.4};
/// How far the fingers close: open, and on the canister.
inline constexpr double kGripOpen = 0.0;
inline constexpr double kGripHolding = 0.06;

/// The arm's base, turned half round towards the station.
inline constexpr Vec3 kArmBase{2.3, -1.0, 0.1};

/// The moments of the motion, seconds. Everything is at rest for 0.25 s or more after kPicked,
/// kWeighed, kLowered and kMeasured: at these moments a frame of a live recording does not depend
/// on how its datagrams were delayed.
struct DemoMoment {
  static constexpr double kCarryShown = 0.3;   ///< the planner shows the gantry's path
  static constexpr double kPicked = 4.6;       ///< the fingers are closed
  static constexpr double kWeighed = 7.7;      ///< half way: the gantry stops to weigh
  static constexpr double kPathShown = 9.4;    ///< the planner shows the arm's path
  static constexpr double kLowered = 10.8;     ///< the canister is set down, the fingers are closed
  static constexpr double kPlaced = 11.1;      ///< the fingers begin to open
  static constexpr double kPathBegins = 11.4;  ///< the arm sets out along the path
  static constexpr double kTraceBegins = 13.5;  ///< the ball touches the lid
  static constexpr double kMeasured = 15.1;     ///< once round: the arm stops to measure
  static constexpr double kSpiralBegins = 15.4;
  static constexpr double kTraceEnds = 17.0;
  static constexpr double kPathEnds = 17.6;  ///< the arm has left the lid
  static constexpr double kErased = 19.5;    ///< all drawings are gone, all is at rest
};

/// The arm's path over the lid in world space, with the corners between its stretches.
struct DemoPath {
  std::vector<Vec3> points;     ///< close enough that the chords stay within 0.5 mm of the path
  std::vector<Vec3> waypoints;  ///< where the tool comes to rest
};
DemoPath armPath();

/// The path of the canister's bottom from the pallet to the station, as the gantry carries it.
DemoPath carryPath();

}  // namespace rocinante
