#pragma once

#include <string>
#include <vector>

#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// The insets that are shown, where they stand in a window of that size: as in a picture, but
/// beside what panels cover. One whose camera is not there, or that repeats the main view, is left
/// out. `fitted` is prepared.
std::vector<FrameInset> frameInsets(ViewModel& model, FittedCameras& fitted, int width, int height,
                                    double scale, const CoveredEdges& covered);

/// "CAMERA:CORNER" of each inset that is shown, as `rocinante render --inset` takes them.
std::vector<std::string> insetWords(const ViewModel& model);

}  // namespace rocinante
