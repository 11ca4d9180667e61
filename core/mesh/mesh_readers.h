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

/// Reads an STL file, binary or ASCII, whose keywords may be in capitals. It is binary when its
/// length matches its count of triangles, even if its header begins with "solid", as many binary
/// files do; else when its first kilobyte has a zero byte, which no text has. Points with equal
/// coordinates are joined; normals come from the winding, smoothed by angle: the file's own normals
/// are one per face and often zero. One part without a name, one grey material.
Result<Mesh> readStl(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
