#pragma once

#include <string>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante {

/// Objects missing in every picture of the cell: "DEVICE/LINK" for each link with a missing or
/// unreadable visual mesh, "DEVICE" for a missing model. In the cell's order. Textures and
/// collision meshes do not count: without them no part is missing. Pure; the cell must have been
/// loaded with geometry.
std::vector<std::string> linksWithoutMesh(const Cell& cell);

/// The same as a sentence: "the picture is incomplete: meshes of arm/forearm and 2 more are missing
/// or cannot be read, first: the mesh `forearm.stl` is not used: ..."; empty when nothing is
/// missing.
std::string incompleteText(const Cell& cell);

/// What is drawn without its texture because the file is not there, a sentence for each name:
/// "the texture `colors.png` is not found: panda/panda_link1 and 8 more are drawn without it".
/// Pure; of the surfaces of visuals alone: a material that nothing is drawn in lacks nothing.
std::vector<std::string> missingTextureTexts(const Cell& cell);

}  // namespace rocinante
