#pragma once

#include <string>
#include <vector>

#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// The shown insets with their places in a window of that size, as in a picture but beside the
/// panels. An inset with an unknown camera or that repeats the main view is left out. `fitted` must
/// be prepared.
std::vector<FrameInset> frameInsets(ViewModel& model, FittedCameras& fitted, int width, int height,
                                    double scale, const CoveredEdges& covered);

/// "CAMERA:CORNER" of each shown inset, for `rocinante render --inset`.
std::vector<std::string> insetWords(const ViewModel& model);

}  // namespace rocinante
