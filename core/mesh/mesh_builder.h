#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Metres from the origin along each axis: beyond the planets, nothing but a broken exporter's
/// number puts a point, and a picture of all would show a dot.
inline constexpr float kFarthestPoint = 1e13F;

/// Whether a point can be drawn: finite and not beyond kFarthestPoint.
inline bool isDrawablePoint(const glm::vec3& p) {
  return std::fabs(p.x) <= kFarthestPoint && std::fabs(p.y) <= kFarthestPoint &&
         std::fabs(p.z) <= kFarthestPoint;
}

/// One corner of a triangle: indices into the arrays of a LooseMesh.
struct Corner {
  std::uint32_t position = 0;
  std::uint32_t texture = kNone;
  std::uint32_t normal = kNone;  ///< kNone: to be computed from the faces around
};

/// A mesh as files store it: separate arrays of positions, texture coordinates and normals, and
/// triangles that pick from each. Already in metres, z up.
struct LooseMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> textures;
  std::vector<glm::vec3> normals;     ///< unit length
  std::vector<std::uint32_t> colors;  ///< 0xRRGGBBAA by position; empty: none
  std::vector<Corner> corners;        ///< three per triangle
  /// By triangle: its smoothing group, 0 for one that is flat, kNone for one that is smoothed by
  /// angle, like the triangles beyond the end.
  std::vector<std::uint32_t> smoothing{};
  std::vector<MeshPart> parts;  ///< first_index and index_count count corners
  std::vector<Material> materials;
};

/// Joins corners that are equal in position, texture and normal into indexed vertices, numbered in
/// the order in which triangles first use them. Every corner must have a normal.
Mesh indexedMesh(LooseMesh&& loose);

/// 0xRRGGBBAA of components in [0, 1]; those outside are clamped, NaN is 0.
std::uint32_t packedColor(const glm::vec4& color);

}  // namespace rocinante
