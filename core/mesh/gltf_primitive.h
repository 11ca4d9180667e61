#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/mesh/gltf_document.h"

namespace rocinante {

/// The triangles of a glTF primitive and the vertices that they use, which may be few of an
/// accessor that many primitives share.
struct GltfTriangles {
  std::vector<std::uint32_t> vertices;  ///< elements of the accessors, in ascending order
  std::vector<std::uint32_t> corners;   ///< three per triangle, into `vertices`
  std::size_t outside = 0;              ///< triangles with a corner that the file does not have
  std::size_t left_over = 0;            ///< corners that make no whole triangle
};

/// By the primitive's `mode` and `indices`; nothing for points and lines. Strips and fans become
/// triangles.
GltfTriangles gltfTriangles(const GltfDocument& document, const GltfJson& primitive);

/// "points" or "lines" when it has no triangles by its mode; else empty.
std::string_view gltfFlatKind(const GltfJson& primitive);

}  // namespace rocinante
