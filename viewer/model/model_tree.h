#pragma once

#include <string>

#include "core/kinematics/model.h"

namespace rocinante {

/// The links of a model as a tree, one a line, each with the joint that holds it, its type and its
/// limits. Drawn with box-drawing characters, or with ASCII alone. Past 64 levels the drawing goes
/// no further to the right, and says how deep it is.
std::string treeText(const Model& model, bool ascii);

}  // namespace rocinante
