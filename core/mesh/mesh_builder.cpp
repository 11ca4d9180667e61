#include "core/mesh/mesh_builder.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

/// How many different corners of one point are compared before one is kept unshared: bounds the
/// work for a file with a million corners on one point.
constexpr int kComparedCorners = 64;

struct SharedVertex {
  std::uint32_t texture;
  std::uint32_t normal;
  std::uint32_t next;  ///< another vertex of the same position
};

}  // namespace

Mesh indexedMesh(LooseMesh&& loose) {
  Mesh mesh;
  mesh.parts = std::move(loose.parts);
  mesh.materials = std::move(loose.materials);
  mesh.indices.reserve(loose.corners.size());
  mesh.vertices.reserve(loose.positions.size());
  std::vector<SharedVertex> shared;
  shared.reserve(loose.positions.size());
  std::vector<std::uint32_t> first_of(loose.positions.size(), kNone);

  for (const Corner& corner : loose.corners) {
    std::uint32_t found = first_of[corner.position];
    for (int compared = 0; found != kNone && compared < kComparedCorners; ++compared) {
      const SharedVertex& vertex = shared[found];
      if (vertex.texture == corner.texture && vertex.normal == corner.normal) break;
      found = compared + 1 == kComparedCorners ? kNone : vertex.next;
    }
    if (found == kNone) {
      found = static_cast<std::uint32_t>(mesh.vertices.size());
      const glm::vec2 texture =
          corner.texture == kNone ? glm::vec2(0.0F) : loose.textures[corner.texture];
      mesh.vertices.push_back(
          {loose.positions[corner.position], loose.normals[corner.normal], texture});
      if (!loose.colors.empty()) mesh.colors.push_back(loose.colors[corner.position]);
      shared.push_back({corner.texture, corner.normal, first_of[corner.position]});
      first_of[corner.position] = found;
    }
    mesh.indices.push_back(found);
  }
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  return mesh;
}

std::uint32_t packedColor(const glm::vec4& color) {
  std::uint32_t packed = 0;
  for (int i = 0; i < 4; ++i) {
    const float component = color[i] > 0.0F ? std::min(color[i], 1.0F) : 0.0F;
    packed = packed << 8U | static_cast<std::uint32_t>(component * 255.0F + 0.5F);
  }
  return packed;
}

}  // namespace rocinante
