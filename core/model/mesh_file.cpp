#include "core/model/mesh_file.h"

#include <algorithm>

#include "core/atomic_file.h"
#include "core/model/mesh_faults.h"
#include "core/model/obj_reader.h"
#include "core/model/stl_reader.h"

namespace rocinante {
namespace {

/// The file's ending in lower case: ".obj".
std::string endingOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending;
}

}  // namespace

Result<Mesh> readMeshBytes(ByteView bytes, const std::filesystem::path& path,
                           const MeshReadOptions& options, ModelFaults& faults) {
  const std::string ending = endingOf(path);
  MeshFaults mesh_faults(faults, path.string());
  if (ending == ".obj") return readObj(bytes, path, options, mesh_faults);
  if (ending == ".stl" || ending == ".stlb") return readStl(bytes, path, options, mesh_faults);
  return Error{ErrorKind::unsupported,
               "is no mesh that can be read: only .obj and .stl are, not " +
                   (ending.empty() ? "a file without an ending" : quotedInFault(ending)),
               path.string()};
}

Result<Mesh> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                          ModelFaults& faults) {
  // Read, not mapped: a file that shrinks while it is loaded would end the program.
  const Result<std::string> content = readFile(path);
  if (!content) return content.error();
  return readMeshBytes(bytesOf(*content), path, options, faults);
}

}  // namespace rocinante
