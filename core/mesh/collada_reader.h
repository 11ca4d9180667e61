#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Reads a COLLADA file (1.4 or 1.5) into one mesh in metres, z up: the file states its unit and up
/// axis, so options.unit_m and options.up are not used. Limits and what is drawn: docs/meshes.md.
///
/// Transforms of nodes are applied; a part's group is the name of the nearest named node above it,
/// so a shape in three places is read three times. A mesh with a skin is drawn where its node is,
/// as it was modelled. Every element that is not used is left out in `faults`. Images are looked
/// for through options.resolve only.
Result<Mesh> readCollada(ByteView bytes, const std::filesystem::path& path,
                         const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
