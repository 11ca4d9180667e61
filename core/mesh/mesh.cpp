#include "core/mesh/mesh.h"

#include <algorithm>
#include <set>

namespace rocinante {

void Bounds::add(const Vec3& point) {
  min = {std::min(min.x, point.x), std::min(min.y, point.y), std::min(min.z, point.z)};
  max = {std::max(max.x, point.x), std::max(max.y, point.y), std::max(max.z, point.z)};
}

void Bounds::add(const Bounds& other) {
  if (other.empty()) return;
  add(other.min);
  add(other.max);
}

std::size_t Mesh::memoryBytes() const {
  std::size_t bytes = sizeof(Mesh) + vertices.capacity() * sizeof(Vertex) +
                      (indices.capacity() + colors.capacity()) * sizeof(std::uint32_t) +
                      parts.capacity() * sizeof(MeshPart) + materials.capacity() * sizeof(Material);
  std::set<const Bytes*> pictures;
  for (const Material& material : materials) {
    const Bytes* picture = material.diffuse_bytes.get();
    if (picture != nullptr && pictures.insert(picture).second) bytes += picture->capacity();
  }
  return bytes;
}

}  // namespace rocinante
