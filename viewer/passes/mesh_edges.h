#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// An edge between triangles of one group. Vertices with equal float positions are one corner.
struct MeshEdge {
  glm::vec3 a{}, b{};
  /// Normals of the two triangles, oriented to the same side: the edge is an outline when one faces
  /// the eye and the other does not. Both zero: always drawn, as a border (one triangle), a crease,
  /// or an edge of more than two triangles.
  glm::vec3 first_normal{}, second_normal{};
  /// Approximate width of the wider adjacent face, between borders and creases: a bar's thickness,
  /// for any length and triangulation.
  float face_width = 0;
};

/// The edges of one part, features first.
struct PartEdges {
  std::uint32_t first = 0;     ///< into MeshEdges::edges
  std::uint32_t features = 0;  ///< borders, creases, and what may become an outline
  std::uint32_t all = 0;       ///< those, and the edges within flat surfaces
};

struct MeshEdges {
  std::vector<MeshEdge> edges;
  std::vector<PartEdges> parts;  ///< by part of the mesh
};

/// Finds all edges of a mesh, each once, in the part of its first triangle. A face written twice,
/// once per side (as by SketchUp), counts once. A crease is an angle over 30 degrees; less than a
/// degree is flat. Pure; sorts three edges per triangle.
MeshEdges meshEdges(const Mesh& mesh);

}  // namespace rocinante
