#include "core/mesh/gltf_primitive.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr std::size_t kTriangleList = 4, kTriangleStrip = 5;

}  // namespace

std::string_view gltfFlatKind(const GltfJson& primitive) {
  const std::size_t mode = gltfIndex(primitive, "mode").value_or(kTriangleList);
  return mode == 0 ? "points" : mode < kTriangleList ? "lines" : "";
}

GltfTriangles gltfTriangles(const GltfDocument& document, const GltfJson& primitive) {
  GltfTriangles triangles;
  if (!gltfFlatKind(primitive).empty()) return triangles;
  const std::size_t mode = gltfIndex(primitive, "mode").value_or(kTriangleList);
  const GltfAccessor positions(document, *gltfIndex(primitive["attributes"], "POSITION"));
  if (!positions.hasBytes()) return triangles;
  std::optional<GltfAccessor> indices;
  if (const auto given = gltfIndex(primitive, "indices")) indices.emplace(document, *given);
  const std::size_t count = indices ? indices->count() : positions.count();
  const auto cornerOf = [&](std::size_t i) {
    return indices ? indices->index(i) : static_cast<std::uint32_t>(i);
  };

  std::vector<std::uint32_t>& corners = triangles.corners;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const std::uint32_t three[] = {cornerOf(a), cornerOf(b), cornerOf(c)};
    if (std::ranges::any_of(three, [&](std::uint32_t at) { return at >= positions.count(); })) {
      ++triangles.outside;
    } else {
      corners.insert(corners.end(), three, three + 3);
    }
  };
  if (mode == kTriangleList) {
    corners.reserve(count);
    for (std::size_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
    triangles.left_over = count % 3;
  } else {
    for (std::size_t i = 0; i + 2 < count; ++i) {
      // Every second triangle of a strip is written the other way round.
      if (mode == kTriangleStrip)
        add(i, i + 1 + i % 2, i + 2 - i % 2);
      else
        add(0, i + 1, i + 2);
    }
    if (count < 3) triangles.left_over = count;
  }

  triangles.vertices = corners;
  std::ranges::sort(triangles.vertices);
  triangles.vertices.erase(std::unique(triangles.vertices.begin(), triangles.vertices.end()),
                           triangles.vertices.end());
  triangles.vertices.shrink_to_fit();
  const bool is_whole = triangles.vertices.size() == positions.count();
  if (is_whole) return triangles;  // every corner is its own place
  for (std::uint32_t& corner : corners) {
    corner = static_cast<std::uint32_t>(std::ranges::lower_bound(triangles.vertices, corner) -
                                        triangles.vertices.begin());
  }
  return triangles;
}

}  // namespace rocinante
