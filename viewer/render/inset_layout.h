#pragma once

#include <string_view>
#include <vector>

#include "core/model/cell.h"
#include "core/result.h"
#include "viewer/render/viewport.h"

namespace rocinante {

/// Where the insets of a picture stand, by inset, as docs/cell-format.md, section "Insets", says;
/// an empty rectangle for one that finds no room. Pure.
std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width, int height,
                                        double scale = 1);

/// "CAMERA" or "CAMERA:CORNER" ("map:bottom-left"), all else by default. A camera's name may hold a
/// colon: what stands behind the last one counts as a corner only when it is one. bad_argument for
/// an empty name.
Result<CellInset> parseInset(std::string_view text);

}  // namespace rocinante
