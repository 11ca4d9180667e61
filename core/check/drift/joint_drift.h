#pragma once

#include <map>
#include <string>

#include "core/check/drift/drift_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Reports drift of the joints: names, order, types, axes, origins, limits, mimics. Returns the
/// renamed links: recorded name to given name.
std::map<std::string, std::string> addJointDrift(const Model& recorded, const Model& given,
                                                 DriftList& drift);

}  // namespace rocinante
