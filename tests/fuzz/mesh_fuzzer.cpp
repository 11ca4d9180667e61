// Any bytes as OBJ, STL (both kinds) and MTL: the first byte chooses. What comes back must be
// drawable: indices in range, unit normals, finite positions.

#include <cmath>
#include <cstdlib>

#include "core/mesh/mesh_file.h"
#include "core/mesh/mtl_reader.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

void requireDrawable(const Mesh& mesh) {
  require(mesh.indices.size() % 3 == 0);
  for (const std::uint32_t index : mesh.indices) require(index < mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    require(std::isfinite(vertex.position.x) && std::isfinite(vertex.position.y) &&
            std::isfinite(vertex.position.z));
    require(std::fabs(glm::dot(vertex.normal, vertex.normal) - 1) < 1e-3F);
  }
  std::uint32_t next = 0;
  for (const MeshPart& part : mesh.parts) {
    require(part.first_index == next && part.material < mesh.materials.size());
    next += part.index_count;
  }
  require(next == mesh.indices.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ByteView bytes = std::as_bytes(std::span(data, size)).subspan(1);
  Findings faults;
  MeshReadOptions options;
  options.up = (data[0] & 4U) != 0 ? UpAxis::y : UpAxis::z;
  options.resolve = [](const std::string&, const std::filesystem::path&) { return FoundFile{}; };
  if (data[0] % 3 == 2) {
    std::vector<Material> materials;
    FaultList list(faults, "fuzz.mtl");
    readMtl(textOf(bytes), "fuzz.mtl", options.resolve, list, materials);
    return 0;
  }
  const Result<Mesh> mesh =
      readMeshBytes(bytes, data[0] % 3 == 0 ? "fuzz.obj" : "fuzz.stl", options, faults);
  if (mesh) requireDrawable(*mesh);
  return 0;
}
