#pragma once

#include <optional>

#include "core/kinematics/model_draft.h"
#include "core/kinematics/urdf_element.h"

namespace rocinante {

/// Reads one `<joint>`; empty with a fault when it has no name, parent or child.
std::optional<JointDraft> readUrdfJoint(const UrdfElement& element);

}  // namespace rocinante
