#pragma once

#include <vector>

#include "core/kinematics/model.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Columns for every value of the model's joints, and the device's own pose last.
std::vector<TrackColumn> columnsOf(const Model& model);

/// Writes into `into` what lies between two rows of these columns, `part` (0 to 1) of the way from
/// the first: angles that may turn for ever and orientations by the shorter way.
void interpolate(const std::vector<TrackColumn>& columns, const double* from, const double* to,
                 double part, double* into);

}  // namespace rocinante
