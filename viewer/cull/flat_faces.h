#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// Triangles of one part that lie in one plane and look one way: in the mesh's space.
struct FlatFace {
  Vec3 normal{};          ///< unit, as the triangles are wound
  Vec3 center{}, half{};  ///< of their bounds
  double area = 0;
  std::vector<std::uint32_t> triangles;  ///< where their three indices begin in the mesh's own
};

struct PartFaces {
  std::vector<FlatFace> faces;  ///< the largest first
  double area = 0;              ///< of the whole part
  bool sheet = false;           ///< all of it lies in one plane
};

/// The flat faces of a part that are large enough to lie on something: at most six, each a fiftieth
/// of the part's area or more. Pure; looks at each triangle once.
PartFaces flatFaces(const Mesh& mesh, const MeshPart& part);

}  // namespace rocinante
