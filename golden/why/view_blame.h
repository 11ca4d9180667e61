#pragma once

#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "golden/why/pixel_blame.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// blameLinks() for each view separately, since an object may move in one view only. An inset whose
/// camera moved is one change of kind `camera`, since everything in it differs. The first view is
/// the main one; insets are identified by their camera's name and place.
Blame blameViews(const BlameSide& golden, const std::vector<PicturedView>& golden_views,
                 const BlameSide& frame, const std::vector<PicturedView>& frame_views,
                 const MovedLinks& moved);

/// guessBlame() for each view separately. The golden's cameras are unknown: an inset whose camera
/// is not fixed by `cell` is one change of kind `camera`.
Blame guessViews(const Picture& golden, const BlameSide& frame,
                 const std::vector<PicturedView>& views, const Cell& cell);

/// "its camera moved by 20 mm and turned by 1.2 deg"; empty when everything in a picture
/// `height_px` high shifts by less than a twentieth of a pixel.
std::string cameraChange(const CameraView& golden, const CameraView& frame, int height_px);

}  // namespace rocinante
