#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Reads an STL file, binary or ASCII, whose keywords may be in capitals. It is binary when its
/// length matches its count of triangles, even if its header begins with "solid", as many binary
/// files do; else when its first kilobyte has a zero byte, which no text has. Points with equal
/// coordinates are joined; normals come from the winding, smoothed by angle: the file's own normals
/// are one per face and often zero. One part without a name, one grey material.
Result<Mesh> readStl(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults);

}  // namespace rocinante
