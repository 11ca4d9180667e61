#pragma once

#include "core/math/vector.h"

namespace rocinante {

/// The angle in radians, 0 to pi, between the orientations of two rigid matrices: exact for small
/// angles, 0 for equal matrices, NaN where one is not finite. The same bits on every CPU.
double turnAngle(const Mat4& a, const Mat4& b);

}  // namespace rocinante
