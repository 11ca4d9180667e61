#include "viewer/cull/flat_faces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFaces = 6;
constexpr double kLeastShare = 1.0 / 50;
/// Thickness of a plane relative to the mesh's size.
constexpr double kThickness = 1e-4;

struct Plane {
  std::uint64_t key = 0;
  FlatFace face;
  Bounds bounds;
};

/// Planes by their keys, in a table that is never full: a mesh may have one for each triangle, and
/// a cell is catalogued each time it is opened.
class PlaneTable {
 public:
  explicit PlaneTable(std::size_t most) : places_(std::bit_ceil(2 * most + 1), kNone) {}

  /// The number of that plane, which is added if it is new.
  std::uint32_t find(std::uint64_t key, const Vec3& normal) {
    std::size_t at = key & (places_.size() - 1);
    while (places_[at] != kNone && planes[places_[at]].key != key) {
      at = (at + 1) & (places_.size() - 1);
    }
    if (places_[at] == kNone) {
      places_[at] = static_cast<std::uint32_t>(planes.size());
      planes.push_back({key, {normal, {}, {}, 0, {}}, {}});
    }
    return places_[at];
  }

  std::vector<Plane> planes;  ///< in the order in which they were added

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> places_;
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
  PlaneTable table(part.index_count / 3);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> placed;  // plane and first index
  placed.reserve(part.index_count / 3);
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
    const std::uint32_t number = table.find(key, normal);
    Plane& plane = table.planes[number];
    plane.face.area += twice_area / 2;
    placed.emplace_back(number, part.first_index + i);
    found.area += twice_area / 2;
    for (const Vec3& corner : p) plane.bounds.add(corner);
  }
  found.sheet = table.planes.size() == 1;
  const auto isLarge = [&](const Plane& plane) {
    return !(plane.face.area < found.area * kLeastShare);
  };
  for (const auto& [number, first] : placed) {
    Plane& plane = table.planes[number];
    if (isLarge(plane)) plane.face.triangles.push_back(first);
  }
  for (Plane& plane : table.planes) {
    if (!isLarge(plane)) continue;
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
