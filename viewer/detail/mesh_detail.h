#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// A coarser version of one part of a mesh, as a run of MeshDetail::indices: `two_sided_count`
/// indices from `first_index`, then `one_sided_count` of triangles seen from their front alone.
struct CoarsePart {
  double error_m = 0;  ///< about how far its surface lies off the part's own; in the mesh's metres
  std::uint32_t first_index = 0;
  std::uint32_t two_sided_count = 0;
  std::uint32_t one_sided_count = 0;
  bool operator==(const CoarsePart&) const = default;
};

/// Coarser versions of a mesh, over its own vertices.
struct MeshDetail {
  std::vector<std::uint32_t> indices;  ///< into Mesh::vertices
  /// By part of the mesh, from fine to coarse, errors growing; empty for parts of few triangles.
  std::vector<std::vector<CoarsePart>> parts;
  bool operator==(const MeshDetail&) const = default;
};

/// A mesh as it is drawn. Borrowed.
struct DetailInput {
  const Mesh* mesh = nullptr;
  /// In place of the mesh's own: each part's one-sided triangles stand last. Same size.
  const std::vector<std::uint32_t>* indices = nullptr;
  /// By part: how many of its indices, the last ones, are of one-sided triangles.
  std::vector<std::uint32_t> one_sided_counts;
};

/// Makes them with meshoptimizer: about half of the triangles each time, as long as the error stays
/// below a twentieth of the part's size. Where parts meet nothing moves, so that no crack opens
/// between parts of different coarseness, and vertices that stand at one place with different
/// normals or texture positions stay together along their seam. Pure: the same input gives the same
/// bits.
MeshDetail makeMeshDetail(const DetailInput& input);

/// What makes two inputs give the same detail, as a name: XXH3 over vertices, indices and parts, 32
/// hexadecimal digits.
std::string detailKey(const DetailInput& input);

}  // namespace rocinante
