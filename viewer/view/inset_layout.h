#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A part of a picture with its own camera: the main view or an inset.
struct PicturedView {
  bool is_inset = false;
  std::string camera;   ///< the inset's name; for the main view as requested
  PixelRectangle part;  ///< the main view's is the whole picture
  CameraView from;
};

/// No picture shows a smaller one.
constexpr int kLeastInsetSidePx = 16;

/// Of an inset in a picture, in pixels, as its cell asks for it.
struct InsetSize {
  int width = 0, height = 0;
  int margin = 0;  ///< to the picture's edge and the inset beside
};
InsetSize insetSize(const CellInset& inset, int width, int height, double scale);

bool isLeft(InsetCorner corner);
bool isTop(InsetCorner corner);

/// The places of a picture's insets, by docs/cell-format.md, section "Insets"; an empty rectangle
/// without room. Pure.
std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width, int height,
                                        double scale = 1);

/// Whether the inset would show the main view: by its camera's name, or because both views are
/// equal.
bool repeatsMainView(const CellInset& inset, std::string_view main_name, const CameraView& main,
                     const PosedScene& scene);

/// "CAMERA[:CORNER][:SIZE]" ("map:bottom-left:0.3x0.2"), with defaults for everything else. SIZE is
/// parts of the picture's, or pixels: "160x120px". A camera's name may contain colons: what follows
/// one is a corner or a size only if it is valid. bad_argument for an empty name.
Result<CellInset> parseInset(std::string_view text);
/// Its title; without one the camera's name, "free view" of a viewpoint in numbers.
std::string insetTitle(const CellInset& inset);
/// The text for parseInset(): camera and corner, and a size that is not the default.
std::string insetText(const CellInset& inset);

}  // namespace rocinante
