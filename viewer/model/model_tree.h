#pragma once

#include <string>

#include "core/kinematics/model.h"

namespace rocinante {

/// The links of a model as a tree, one per line, each with its joint, the joint's type and limits.
/// Drawn with box-drawing characters or only ASCII. Beyond 64 levels lines are not indented further
/// but show their depth.
std::string treeText(const Model& model, bool ascii);

}  // namespace rocinante
