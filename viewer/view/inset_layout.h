#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// What panels of a window cover of its picture, in pixels: insets stand beside it.
struct CoveredEdges {
  int left = 0, bottom = 0;
  int right = 0;      ///< how wide what lies at the right edge is
  int right_top = 0;  ///< how far down it goes, from the top
};

/// Where the insets of a picture stand, by inset, as docs/cell-format.md, section "Insets", says;
/// an empty rectangle for one that finds no room. Beside what is covered: at the right below it
/// where they have room, those at the bottom first, else to its left; made smaller where that is
/// not enough, and so that those of the left and the right do not meet. Pure.
std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width, int height,
                                        double scale = 1, const CoveredEdges& covered = {});

/// Whether the inset would show what the main view shows: by its camera's name, or because both
/// cameras are the same.
bool repeatsMainView(const CellInset& inset, std::string_view main_name, const CameraView& main,
                     const PosedScene& scene);

/// "CAMERA" or "CAMERA:CORNER" ("map:bottom-left"), all else by default. A camera's name may hold a
/// colon: what stands behind the last one counts as a corner only when it is one. bad_argument for
/// an empty name.
Result<CellInset> parseInset(std::string_view text);

}  // namespace rocinante
