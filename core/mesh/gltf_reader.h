#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Reads glTF 2 (.gltf, .glb) into one mesh in metres, z up (docs/decisions/037): the format states
/// its unit and up axis, so options.unit_m and options.up are not used.
///
/// Transforms of nodes, instances (EXT_mesh_gpu_instancing) and skins at rest are applied; a part's
/// group is the name of the nearest named node above it, so a shape in three places is read three
/// times. Only the vertices that triangles use are read. Files that this one names are read only
/// through options.resolve. Embedded images become Material::diffuse_bytes. What is not used is
/// named (FaultList::leaveOut). damaged when an index, a length or a type is wrong.
Result<Mesh> readGltf(ByteView bytes, const std::filesystem::path& path,
                      const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
