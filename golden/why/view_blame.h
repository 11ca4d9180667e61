#pragma once

#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "golden/why/pixel_blame.h"
#include "viewer/view/pictured_view.h"

namespace rocinante {

/// blameLinks() of each view by itself, since what moves in one stands still in another. An inset
/// whose camera moved is one change of kind `camera`: everything in it differs, and by that alone.
/// The views begin with the main one; insets are told apart by their cameras' names and places.
Blame blameViews(const BlameSide& golden, const std::vector<PicturedView>& golden_views,
                 const BlameSide& frame, const std::vector<PicturedView>& frame_views,
                 const MovedLinks& moved);

/// guessBlame() of each view by itself. Where the golden's cameras were is unknown: an inset whose
/// camera `cell` does not fix in space is one change of kind `camera`.
Blame guessViews(const Picture& golden, const BlameSide& frame,
                 const std::vector<PicturedView>& views, const Cell& cell);

/// "its camera moved by 20 mm and turned by 1.2 deg"; empty when that shifts nothing in a picture
/// `height_px` high by a twentieth of a pixel.
std::string cameraChange(const CameraView& golden, const CameraView& frame, int height_px);

}  // namespace rocinante
