#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/math/vector.h"
#include "player/demo_arm.h"

namespace rocinante {

/// The demo's motion as functions of time: seconds after its zero, clamped to its ends. Metres,
/// radians; world space unless said otherwise. The places repeat those of examples/demo.

/// Joint values of the gantry: x, y (bridge, trolley), z (hoist, downwards), grip (closing).
using GantryJoints = std::array<double, 4>;
GantryJoints gantryJointsAt(double seconds);
ArmJoints armJointsAt(double seconds);

/// Where the middle of the canister's bottom is while nothing carries it; upright.
inline constexpr Vec3 kCanisterAtPallet{-2.4, -1.0, 0.25};
inline constexpr Vec3 kCanisterAtStation{1.25, -1.0, 0.55};
inline constexpr double kCanisterHeight = 0.50;
/// The canister's bottom in the space of gantry/gripper, when it is held.
inline constexpr Vec3 kCanisterInGripper{0, 0, -0.54};
/// Where gantry/gripper is with all joints at zero.
inline constexpr Vec3 kGripperAtZero{0, 0, 2.4};
/// How far the fingers close: open, and on the canister.
inline constexpr double kGripOpen = 0.0;
inline constexpr double kGripHolding = 0.06;

/// The arm stands here, turned half round, towards the station.
inline constexpr Vec3 kArmBase{2.3, -1.0, 0.1};

/// The moments that the planner and the gantry's packets speak of, seconds.
struct DemoMoment {
  static constexpr double kCarryShown = 0.3;    ///< the planner shows the gantry's way
  static constexpr double kPicked = 5.0;        ///< the fingers are closed
  static constexpr double kPathShown = 9.4;     ///< the planner shows the arm's path
  static constexpr double kPlaced = 10.9;       ///< the canister stands, the fingers begin to open
  static constexpr double kPathBegins = 11.3;   ///< the arm sets out along the path
  static constexpr double kTraceBegins = 13.5;  ///< the ball touches the lid
  static constexpr double kTraceEnds = 17.2;
  static constexpr double kPathEnds = 17.7;  ///< the arm has left the lid
  static constexpr double kErased = 19.2;
};

/// The arm's path over the lid in world space, with the corners between its stretches.
struct DemoPath {
  std::vector<Vec3> points;     ///< close enough that the chords stay within 0.5 mm of the path
  std::vector<Vec3> waypoints;  ///< where the tool comes to rest
};
DemoPath armPath();

/// The way of the canister's bottom from the pallet to the station, as the gantry carries it.
DemoPath carryPath();

}  // namespace rocinante
