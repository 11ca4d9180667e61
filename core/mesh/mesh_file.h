#pragma once

#include <filesystem>
#include <functional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/report/finding.h"
#include "core/search/found_file.h"

namespace rocinante {

enum class UpAxis : std::uint8_t { y, z };

/// Where a file that another file names may be found; nothing outside the search roots is opened.
/// `beside` is the folder of the file that names it.
/// Without a path: not found or not allowed (the callee then adds the fault).
using ResolveFile =
    std::function<FoundFile(const std::string& name, const std::filesystem::path& beside)>;

struct MeshReadOptions {
  double unit_m = 1.0;  ///< metres per unit of the file
  UpAxis up = UpAxis::z;
  ResolveFile resolve;  ///< for mtllib and textures; empty: in the file's folder or below only
  double smooth_angle_deg = 40;  ///< missing normals: faces that meet at less are smoothed
};

/// Limits of a COLLADA or glTF file; more is refused (docs/meshes.md, "Limits").
inline constexpr std::size_t kMaxSceneBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMaxSceneTriangles = std::size_t{1} << 24;

/// By the file's ending: .obj .stl .stlb .dae .gltf .glb.
bool isMeshFile(const std::filesystem::path& path);
/// True for COLLADA and glTF; OBJ and STL state neither unit nor up axis.
bool statesUnit(const std::filesystem::path& path);

/// Reads .obj (with .mtl), .stl, binary and ASCII, .dae, .gltf or .glb by the file's ending. Faults
/// of the file are added to `faults` with their lines and as much as is sound is returned; an error
/// only when nothing can be used. Details per format: mesh_readers.h.
Result<Mesh> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                          Findings& faults);

/// The same from bytes: for tests and fuzzers. `path` names them and says the format.
Result<Mesh> readMeshBytes(ByteView bytes, const std::filesystem::path& path,
                           const MeshReadOptions& options, Findings& faults);

}  // namespace rocinante
