#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/math/vector.h"

namespace rocinante {

/// How near a link's joint stands to its limits.
enum class LimitLevel : std::uint8_t {
  inside,
  near,    ///< within 5 % of the range of an end of it
  beyond,  ///< past an end, or no number at all
};

/// A link's way up to the moment of the frame, oldest first, in the world.
struct Trail {
  struct Point {
    Vec3 at{};
    float fresh = 0;  ///< 0 at the far end of the window, 1 at the moment of the frame
    bool operator==(const Point&) const = default;
  };
  std::string path;
  /// Runs without a gap; a device that was not there for a while leaves one.
  std::vector<std::vector<Point>> runs;
};

/// What some looks of a frame need besides the scene: read off the state and the log, never off
/// what was drawn before (frame_extras is made by limitLevels() and TrailFinder).
struct FrameExtras {
  /// By device of the scene, by link of its model; empty: nothing is tinted.
  std::vector<std::vector<LimitLevel>> limits;
  std::vector<Trail> trails;
};

}  // namespace rocinante
