#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_file.h"

namespace rocinante::test {

/// A mesh read from text, with its faults.
struct ReadMesh {
  Mesh mesh;
  Findings faults;

  std::vector<std::string> rules() const {
    std::vector<std::string> rules;
    for (const Finding& fault : faults) rules.push_back(fault.rule);
    return rules;
  }
  /// Rules of what is wrong with the file: not of notes.
  std::vector<std::string> blame() const {
    std::vector<std::string> rules;
    for (const Finding& fault : faults) {
      if (fault.severity != Severity::note) rules.push_back(fault.rule);
    }
    return rules;
  }
  /// "element `light`": the file's account.
  std::vector<std::string> leftOut() const {
    std::vector<std::string> left_out;
    for (const Finding& fault : faults) {
      if (!fault.left_out.empty()) left_out.push_back(fault.left_out);
    }
    return left_out;
  }
  /// The corners of triangle `i`, as positions.
  std::vector<glm::vec3> triangle(std::size_t i) const {
    std::vector<glm::vec3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      corners.push_back(mesh.vertices[mesh.indices[i * 3 + c]].position);
    }
    return corners;
  }
};

inline ReadMesh readMesh(std::string_view text, const std::string& name,
                         const MeshReadOptions& options = {}) {
  ReadMesh read;
  Result<Mesh> mesh = readMeshBytes(bytesOf(text), name, options, read.faults);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  if (mesh) read.mesh = std::move(*mesh);
  return read;
}

/// Every index in range, normals of unit length, parts that cover the triangles, bounds that hold.
inline void expectSound(const Mesh& mesh) {
  ASSERT_EQ(mesh.indices.size() % 3, 0U);
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    ASSERT_NEAR(glm::dot(vertex.normal, vertex.normal), 1.0F, 1e-5F);
    ASSERT_GE(vertex.position.x, mesh.bounds.min.x);
    ASSERT_LE(vertex.position.z, mesh.bounds.max.z);
  }
  std::uint32_t next = 0;
  for (const MeshPart& part : mesh.parts) {
    ASSERT_EQ(part.first_index, next);
    ASSERT_GT(part.index_count, 0U);
    ASSERT_LT(part.material, mesh.materials.size());
    next += part.index_count;
  }
  ASSERT_EQ(next, mesh.indices.size());
}

/// Everything that a picture or a terminal would show of a mesh.
inline std::string told(const Result<Mesh>& mesh, const Findings& faults) {
  std::string told;
  for (const Finding& fault : faults) {
    told += fmt::format("{} {} {} x{}\n", fault.rule, fault.left_out, fault.text, fault.count);
  }
  if (!mesh) return told + mesh.error().what;
  expectSound(*mesh);
  for (const std::uint32_t index : mesh->indices) {
    const Vertex& v = mesh->vertices[index];
    told += fmt::format("{} {} {} {} {} {} {} {} {:x}\n", v.position.x, v.position.y, v.position.z,
                        v.normal.x, v.normal.y, v.normal.z, v.texture.x, v.texture.y,
                        mesh->colors.empty() ? 0 : mesh->colors[index]);
  }
  for (const MeshPart& part : mesh->parts) {
    told += fmt::format("{} {} {}\n", part.group, part.material, part.index_count);
  }
  for (const Material& m : mesh->materials) {
    told += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}\n", m.name, m.diffuse.r,
                        m.diffuse.b, m.diffuse.a, m.specular.r, m.emission.b, m.shininess,
                        m.diffuse_map.string(), m.missing_map, static_cast<int>(m.wrap_u),
                        static_cast<int>(m.wrap_v), m.map_scale.x, m.map_offset.x);
  }
  return told;
}

/// Twice the area of all triangles, seen along z: cutting a flat polygon must not change it.
inline double flatArea(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[mesh.indices[i]].position);
    const Vec3 b(mesh.vertices[mesh.indices[i + 1]].position);
    const Vec3 c(mesh.vertices[mesh.indices[i + 2]].position);
    sum += glm::cross(b - a, c - a).z;
  }
  return sum;
}

}  // namespace rocinante::test
