#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// An edge between triangles of one group. Positions that are equal as floats are one corner.
struct MeshEdge {
  glm::vec3 a{}, b{};
  /// Of the two triangles that meet here, turned so that both look out of the same side: the edge
  /// is an outline where one faces the eye and the other does not. Both zero: it is always drawn,
  /// being a border (one triangle), a crease, or where more than two meet.
  glm::vec3 first_normal{}, second_normal{};
  /// About how wide the wider of the faces is that meet here, as far as its borders and creases:
  /// of a bar its thickness, however long it is and however it is cut into triangles.
  float face_width = 0;
};

/// The edges of one part, those that lines are drawn along first.
struct PartEdges {
  std::uint32_t first = 0;     ///< into MeshEdges::edges
  std::uint32_t features = 0;  ///< borders, creases, and what may become an outline
  std::uint32_t all = 0;       ///< those, and the edges within flat surfaces
};

struct MeshEdges {
  std::vector<MeshEdge> edges;
  std::vector<PartEdges> parts;  ///< by part of the mesh
};

/// Finds all edges of a mesh, each once, with the part of its first triangle. A face written twice,
/// once for each side (as SketchUp does), counts once. A crease turns by more than 30 degrees; less
/// than a degree is flat. Pure; sorts three edges a triangle.
MeshEdges meshEdges(const Mesh& mesh);

}  // namespace rocinante
