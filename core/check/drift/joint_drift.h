#pragma once

#include <map>
#include <string>

#include "core/check/drift/drift_list.h"
#include "core/kinematics/model.h"
#include "core/math/vector.h"

namespace rocinante {

/// "has moved by 12 mm and turned by 3.5 degrees"; empty when the two are the same within rounding.
std::string poseDrift(const Pose& recorded, const Pose& given);

/// Between two unit vectors, in degrees; 0 when they are the same within rounding.
double angleDrift_deg(const Vec3& recorded, const Vec3& given);

/// True when two numbers are the same within rounding.
bool isSameNumber(double a, double b);

/// Reports drift of the joints: names, order, types, axes, origins, limits, mimics. Returns the
/// renamed links: recorded name to given name.
std::map<std::string, std::string> addJointDrift(const Model& recorded, const Model& given,
                                                 DriftList& drift);

}  // namespace rocinante
