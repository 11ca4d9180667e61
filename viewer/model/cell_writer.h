#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante {

/// A cell of one device (docs/cell-format.md): its kinematics as [[model.link]] tables over the
/// groups of an OBJ. `groups` is by link of the model: empty for links without geometry. Numbers
/// are the shortest that read back as the same double.
std::string cellText(const CellDevice& device, const Model& model, const std::string& obj_file,
                     const std::vector<std::string>& groups);

}  // namespace rocinante
