#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/clearance/clearance_gauge.h"
#include "core/math/vector.h"

namespace rocinante {

/// How near a link's joint is to its limits.
enum class LimitLevel : std::uint8_t {
  inside,
  near,    ///< within 5 % of the range of an end of it
  beyond,  ///< past an end, or NaN
};

/// A link's path up to the moment of the frame, oldest point first, in world space.
struct Trail {
  struct Point {
    Vec3 at{};
    float fresh = 0;  ///< 0 at the start of the window, 1 at the frame's moment
    bool operator==(const Point&) const = default;
  };
  std::string path;
  /// Runs without gaps; a device that was absent leaves a gap.
  std::vector<std::vector<Point>> runs;
};

/// The nearest points of two devices whose distance `check` judges, in the world.
struct ClearanceLine {
  Vec3 from{}, to{};
  double distance_m = 0;
  bool is_kept = true;  ///< not nearer than the cell's least distance
  bool operator==(const ClearanceLine&) const = default;
};

/// Data for some looks besides the scene, computed only from the state and the log (ScenePoser).
struct FrameExtras {
  /// By device of the scene and link of its model; empty: no tint.
  std::vector<std::vector<LimitLevel>> limits;
  std::vector<Trail> trails;
  std::vector<ClearanceLine> clearances;
  /// One more such line, which no clearance of the cell asks for.
  std::optional<ClearanceLine> nearest;
};

/// FrameExtras::limits of a scene posed from `state`: by device, by link. A link's joint counts
/// when it is revolute or prismatic and has a range; mimic joints too.
std::vector<std::vector<LimitLevel>> limitLevels(const PosedScene& scene,
                                                 const SessionState& state);

/// The level of one value: near within 5 % of the range from an end; beyond when past an end by
/// more than a millionth of the range (values are rounded), or NaN.
LimitLevel limitLevel(const JointLimits& limits, double value);

/// The lines of the cell's clearances in a state, in their order. `gauge` is of the same cell.
std::vector<ClearanceLine> clearanceLines(const Cell& cell, ClearanceGauge& gauge,
                                          const SessionState& state);

}  // namespace rocinante
