#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// Triangles of one part in one plane that face the same way, in mesh space.
struct FlatFace {
  Vec3 normal{};          ///< unit length, by the winding
  Vec3 center{}, half{};  ///< of the bounding box
  double area = 0;
  std::vector<std::uint32_t> triangles;  ///< first of their three indices in the mesh
};

struct PartFaces {
  std::vector<FlatFace> faces;  ///< the largest first
  double area = 0;              ///< of the whole part
  bool sheet = false;           ///< all of it lies in one plane
};

/// The large flat faces of a part: at most six, each at least a fiftieth of the part's area. Pure;
/// visits each triangle once.
PartFaces flatFaces(const Mesh& mesh, const MeshPart& part);

}  // namespace rocinante
