#pragma once

#include <string>

#include "core/kinematics/joint_values.h"
#include "core/math/transform.h"
#include "viewer/view/units.h"

namespace rocinante {

/// A joint's value: "23.60°", "1234.5 mm", or "0.5000" for a part of a quaternion.
std::string jointValueText(ValueKind kind, double value, const Units& units);

/// "at 1234.5 -20.0 3.0 mm"
std::string positionText(const Vec3& position, LengthUnit unit);

}  // namespace rocinante
