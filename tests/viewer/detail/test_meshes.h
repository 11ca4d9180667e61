#pragma once

#include <cmath>
#include <cstdint>

#include "core/mesh/mesh.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante::test {

/// A sheet of `side` x `side` squares in z = height(x, y), one metre wide, in as many parts as
/// asked for, which meet along lines of constant x.
template <class Height>
Mesh sheetMesh(int side, int parts, const Height& height) {
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      const double u = static_cast<double>(x) / side;
      const double v = static_cast<double>(y) / side;
      const glm::vec3 position(u, v, height(u, v));
      mesh.vertices.push_back({position, {0, 0, 1}, {u, v}});
      mesh.bounds.add(Vec3(position));
    }
  }
  const auto at = [side](int x, int y) { return static_cast<std::uint32_t>(y * (side + 1) + x); };
  for (int part = 0; part < parts; ++part) {
    MeshPart run{"part", 0, static_cast<std::uint32_t>(mesh.indices.size()), 0};
    for (int y = 0; y < side; ++y) {
      for (int x = side * part / parts; x < side * (part + 1) / parts; ++x) {
        const std::uint32_t a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
        mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
      }
    }
    run.index_count = static_cast<std::uint32_t>(mesh.indices.size()) - run.first_index;
    mesh.parts.push_back(run);
  }
  mesh.materials.push_back(Material{});
  return mesh;
}

inline Mesh hillsMesh(int side, int parts = 1) {
  return sheetMesh(side, parts,
                   [](double u, double v) { return 0.1 * std::sin(9 * u) * std::cos(7 * v); });
}

inline DetailInput inputOf(const Mesh& mesh) {
  return {&mesh, &mesh.indices, std::vector<std::uint32_t>(mesh.parts.size())};
}

}  // namespace rocinante::test
