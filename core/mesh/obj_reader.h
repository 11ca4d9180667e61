#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Reads a Wavefront OBJ file and the material files that it names.
///
/// A part's group is what the last `g` named, the whole line with its inner blanks; where no `g`
/// came since the last `o`, the object's name. Polygons are cut into triangles (concave ones too);
/// faces with missing corners are left out with a fault. Missing normals are smoothed within a
/// group: of faces behind an `s` by its smoothing group, of others by angle. Colours behind the
/// positions (`v x y z r g b`, 0 to 1) colour the points; lines, points and weights are ignored. A
/// material that no file defines gets grey, or white where the points have colours.
Result<Mesh> readObj(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
