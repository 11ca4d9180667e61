#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// The mesh with about half of its triangles, `halvings` times, as makeMeshDetail() leaves them
/// out: parts that are small, or would be farther from their surface than a twentieth of their
/// size, keep more. Parts, materials and bounds stay; a primitive shape stays whole. Pure.
Mesh coarseMesh(const Mesh& mesh, int halvings);

/// A coarser version of one part of a mesh, as a run of MeshDetail::indices: `two_sided_count`
/// indices from `first_index`, then `one_sided_count` of one-sided triangles.
struct CoarsePart {
  double error_m = 0;  ///< approximate distance from the part's surface, in mesh space
  std::uint32_t first_index = 0;
  std::uint32_t two_sided_count = 0;
  std::uint32_t one_sided_count = 0;
  bool operator==(const CoarsePart&) const = default;
};

/// Coarser versions of a mesh, over its own vertices.
struct MeshDetail {
  std::vector<std::uint32_t> indices;  ///< into Mesh::vertices
  /// By part of the mesh, from fine to coarse, with increasing errors; empty for parts of few
  /// triangles.
  std::vector<std::vector<CoarsePart>> parts;
  bool operator==(const MeshDetail&) const = default;
};

/// A mesh as it is drawn. Borrowed.
struct DetailInput {
  const Mesh* mesh = nullptr;
  /// Replaces the mesh's own: each part's one-sided triangles last. Same size.
  const std::vector<std::uint32_t>* indices = nullptr;
  /// By part: the number of its last indices that belong to one-sided triangles.
  std::vector<std::uint32_t> one_sided_counts;
};

/// Simplifies with meshoptimizer: about half of the triangles each time, while the error stays
/// below a twentieth of the part's size. Borders between parts do not move, so that no crack opens
/// between parts of different coarseness, and coincident vertices with different normals or texture
/// coordinates stay together. Pure: the same input gives the same bits.
MeshDetail makeMeshDetail(const DetailInput& input);

/// Key of the input: XXH3 over vertices, indices and parts, 32 hexadecimal digits.
std::string detailKey(const DetailInput& input);

}  // namespace rocinante
