#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Limits of a COLLADA or glTF file; more is refused (docs/meshes.md, "Limits").
inline constexpr std::size_t kMaxSceneBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMaxSceneTriangles = std::size_t{1} << 24;

/// Reads COLLADA (.dae) with the assimp library into one mesh in metres, z up: the format states
/// its unit and up axis, so options.unit_m and options.up are not used.
///
/// Transforms of nodes are applied; a part's group is the name of the nearest named node above it,
/// so a shape in three places is read three times. Cameras, lights, animations, skins and morph
/// targets are ignored. Files that this one names are read only through options.resolve. Embedded
/// images become Material::diffuse_bytes.
/// damaged with assimp's own reason when it cannot read the file.
Result<Mesh> readScene(ByteView bytes, const std::filesystem::path& path,
                       const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
