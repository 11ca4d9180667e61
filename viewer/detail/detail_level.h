#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rocinante {

/// How much of what is there a frame draws. The default is everything, as the files have it.
struct DetailLevel {
  /// Geometry may lie so many pixels off its true place: coarser meshes are drawn where they do no
  /// worse. 0: the files' own triangles.
  double geometry_error_px = 0;
  /// What is less than so many pixels across is left out. 0: nothing.
  double cull_below_px = 0;
  /// Textures with the cheapest filter that still uses mipmaps.
  bool plain_filtering = false;
  bool operator==(const DetailLevel&) const = default;
};

/// One rung of the ladder on which a window goes down to hold its frame rate.
struct DetailRung {
  double resolution = 1;     ///< of width and height of the 3D view; scaled up below the interface
  bool multisampled = true;  ///< as many samples as were asked for; else one
  DetailLevel level;
  /// What it costs of rung 0 at best, where what it saves is all that costs: a bound by which
  /// several rungs may be taken at once without going too far.
  double best_cost = 1;
};

/// From everything (0) to the least: first resolution, samples and filtering, which pay most in
/// software, then coarser geometry, then leaving out what is small.
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
