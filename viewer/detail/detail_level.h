#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rocinante {

/// The level of detail of a frame. The default draws everything as in the files.
struct DetailLevel {
  /// Largest error of geometry in pixels: coarser meshes are drawn within it. 0: the files' own
  /// triangles.
  double geometry_error_px = 0;
  /// Parts smaller than this many pixels across are left out. 0: none.
  double cull_below_px = 0;
  /// Filter textures with the cheapest mode that uses mipmaps.
  bool plain_filtering = false;
  bool operator==(const DetailLevel&) const = default;
};

/// One rung of the ladder that a window descends to hold its frame rate.
struct DetailRung {
  double resolution = 1;     ///< of the 3D view's sides; scaled up below the interface
  bool multisampled = true;  ///< the requested samples; else one
  DetailLevel level;
  /// Lower bound of its cost relative to rung 0, used to descend several rungs at once without
  /// going too far.
  double best_cost = 1;
};

/// From everything (0) to the least: first resolution, samples and filtering, which save most in
/// software, then coarser geometry, then dropping small parts.
constexpr std::array kDetailRungs{
    DetailRung{1.00, true, {0, 0, false}, 1.0},       //
    DetailRung{0.85, true, {0, 0, false}, 0.72},      //
    DetailRung{0.70, true, {0, 0, false}, 0.49},      //
    DetailRung{0.70, false, {0, 0, false}, 0.14},     //
    DetailRung{0.70, false, {0, 0, true}, 0.056},     //
    DetailRung{0.70, false, {0.75, 0, true}, 0.011},  //
    DetailRung{0.70, false, {1.5, 0, true}, 0.005},   //
    DetailRung{0.70, false, {3, 0, true}, 0.003},     //
    DetailRung{0.60, false, {3, 2, true}, 0.0015},    //
    DetailRung{0.50, false, {6, 4, true}, 0.0007},    //
};
constexpr int kCoarsestRung = static_cast<int>(kDetailRungs.size()) - 1;

/// The rung that `--detail TEXT` names: 0 to kCoarsestRung; empty for any other text.
std::optional<int> parseDetailRung(std::string_view text);

}  // namespace rocinante
