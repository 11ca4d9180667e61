#pragma once

#include <vector>

#include "core/kinematics/model.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Columns for every value of the model's joints, and the device's own pose last.
std::vector<TrackColumn> columnsOf(const Model& model);

/// Writes into `out` the value between `a` and `b` of a column, `part` (0 to 1) of the way from
/// `a`: angles that may turn for ever and orientations by the shorter way.
void interpolate(const TrackColumn& column, const double* a, const double* b, double part,
                 double* out);

}  // namespace rocinante
