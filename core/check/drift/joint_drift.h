#pragma once

#include <map>
#include <string>

#include "core/check/drift/drift_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// What has drifted in the joints: names, order, types, axes, origins, limits, mimics. Answers with
/// the names of links that have others now: recorded name to given name.
std::map<std::string, std::string> addJointDrift(const Model& recorded, const Model& given,
                                                 DriftList& drift);

}  // namespace rocinante
