#pragma once

#include <string>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante {

/// What no picture of the cell can show: "DEVICE/LINK" for each link of which a visual mesh is
/// missing or cannot be read, "DEVICE" where its whole model is. By device, as the cell has them.
/// Textures and collision meshes are not meant: without them a picture has another look, and no
/// part less. Pure; the cell was loaded with its geometry.
std::vector<std::string> linksWithoutMesh(const Cell& cell);

/// The same as a sentence: "the picture is incomplete: meshes of arm/forearm and 2 more are missing
/// or cannot be read, first: the mesh `forearm.stl` is not used: ..."; empty where nothing is
/// missing.
std::string incompleteText(const Cell& cell);

}  // namespace rocinante
