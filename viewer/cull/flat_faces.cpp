#include "viewer/cull/flat_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFaces = 6;
constexpr double kLeastShare = 1.0 / 50;
/// Thickness of a plane relative to the mesh's size.
constexpr double kThickness = 1e-4;

struct Plane {
  FlatFace face;
  Bounds bounds;
};

/// Nearby planes with one direction have one key, unless rounding separates them; then each half is
/// its own face.
std::uint64_t keyOf(const Vec3& normal, double offset) {
  std::uint64_t key = 0;
  for (const double value : {normal.x * 256, normal.y * 256, normal.z * 256, offset}) {
    const auto whole = static_cast<std::int64_t>(std::floor(value + 0.5));
    key = (key ^ static_cast<std::uint64_t>(whole)) * 0x9E3779B97F4A7C15U;
    key ^= key >> 29U;
  }
  return key;
}

}  // namespace

PartFaces flatFaces(const Mesh& mesh, const MeshPart& part) {
  PartFaces found;
  const Vec3 size = mesh.bounds.max - mesh.bounds.min;
  const double thickness = std::max({size.x, size.y, size.z}) * kThickness;
  if (mesh.bounds.empty() || !(thickness > 0) || !std::isfinite(thickness)) return found;
  std::vector<Plane> planes;  // in the order of their first triangles
  std::unordered_map<std::uint64_t, std::size_t> by_key;
  for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3) {
    std::array<Vec3, 3> p;
    for (std::uint32_t k = 0; k < 3; ++k) {
      p[k] = Vec3(mesh.vertices[mesh.indices[part.first_index + i + k]].position);
    }
    Vec3 normal = crossOf(p[1] - p[0], p[2] - p[0]);
    const double twice_area = lengthOf(normal);
    if (!(twice_area > 0) || !std::isfinite(twice_area)) continue;
    normal /= twice_area;
    const std::uint64_t key = keyOf(normal, dotOf(normal, p[0] - mesh.bounds.min) / thickness);
    const auto [place, is_new] = by_key.emplace(key, planes.size());
    if (is_new) planes.push_back({{normal, {}, {}, 0, {}}, {}});
    Plane& plane = planes[place->second];
    plane.face.area += twice_area / 2;
    plane.face.triangles.push_back(part.first_index + i);
    found.area += twice_area / 2;
    for (const Vec3& corner : p) plane.bounds.add(corner);
  }
  found.sheet = planes.size() == 1;
  for (Plane& plane : planes) {
    if (plane.face.area < found.area * kLeastShare) continue;
    plane.face.center = (plane.bounds.min + plane.bounds.max) * 0.5;
    plane.face.half = (plane.bounds.max - plane.bounds.min) * 0.5;
    found.faces.push_back(std::move(plane.face));
  }
  std::stable_sort(found.faces.begin(), found.faces.end(),
                   [](const FlatFace& a, const FlatFace& b) { return a.area > b.area; });
  if (found.faces.size() > kMaxFaces) found.faces.resize(kMaxFaces);
  return found;
}

}  // namespace rocinante
