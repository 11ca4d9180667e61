#pragma once

#include <string>
#include <vector>

#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/view_model.h"

namespace rocinante {

/// What panels cover at the edges of the window, in pixels: insets stand beside it.
struct CoveredEdges {
  int left = 0, bottom = 0;
  int right_top = 0;  ///< how far down the right edge is covered from the top
};

/// The insets that are shown, where they stand in a window of that size: as in a picture, but moved
/// away from what panels cover. One whose camera is not there is left out. `fitted` is prepared.
std::vector<FrameInset> frameInsets(const ViewModel& model, FittedCameras& fitted, int width,
                                    int height, double scale, const CoveredEdges& covered);

/// "CAMERA:CORNER" of each inset that is shown, as `rocinante render --inset` takes them.
std::vector<std::string> insetWords(const ViewModel& model);

}  // namespace rocinante
