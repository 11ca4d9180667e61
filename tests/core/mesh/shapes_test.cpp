#include "core/mesh/shapes.h"

#include <cmath>

#include "core/base/hash.h"
#include "tests/core/mesh/mesh_test_support.h"

namespace rocinante {
namespace {

using test::expectSound;

/// Six times the enclosed volume: positive when the triangles face outward.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[mesh.indices[i]].position);
    const Vec3 b(mesh.vertices[mesh.indices[i + 1]].position);
    const Vec3 c(mesh.vertices[mesh.indices[i + 2]].position);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

void expectOutward(const Mesh& mesh) {
  expectSound(mesh);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
    ASSERT_GT(glm::dot(across, across), 0.0F) << "triangle " << i / 3 << " is empty";
    EXPECT_GT(glm::dot(across, a.normal + b.normal + c.normal), 0.0F) << "triangle " << i / 3;
  }
}

TEST(Shapes, ABoxHasSixFacesOfItsSize) {
  const Mesh box = boxMesh({1, 2, 3});
  expectOutward(box);
  EXPECT_EQ(box.vertices.size(), 24U);
  EXPECT_EQ(box.triangleCount(), 12U);
  EXPECT_DOUBLE_EQ(volume(box), 6.0);
  EXPECT_EQ(box.bounds.min, Vec3(-0.5, -1, -1.5));
  EXPECT_EQ(box.bounds.max, Vec3(0.5, 1, 1.5));
}

TEST(Shapes, ACylinderStandsAlongZ) {
  const Mesh cylinder = cylinderMesh(0.5, 2);
  expectOutward(cylinder);
  EXPECT_EQ(cylinder.triangleCount(), 48U * 4);
  EXPECT_NEAR(volume(cylinder), 48 * 0.125 * std::sin(2 * M_PI / 48) * 2, 1e-6);
  EXPECT_EQ(cylinder.bounds.max, Vec3(0.5, 0.5, 1));
  EXPECT_EQ(cylinder.bounds.min.z, -1);
}

TEST(Shapes, ASphereReachesItsRadiusEverywhere) {
  const Mesh sphere = sphereMesh(2);
  expectOutward(sphere);
  for (const Vertex& vertex : sphere.vertices) {
    EXPECT_NEAR(glm::dot(vertex.position, vertex.position), 4.0F, 1e-5F);
  }
  EXPECT_NEAR(volume(sphere), 4.0 / 3 * M_PI * 8, 0.4);
  EXPECT_EQ(sphere.bounds.max.z, 2);
  EXPECT_EQ(sphere.bounds.min.z, -2);
}

TEST(Shapes, ACapsuleIsACylinderWithHalfSpheres) {
  const Mesh capsule = capsuleMesh(0.5, 2);
  expectOutward(capsule);
  EXPECT_EQ(capsule.bounds.max.z, 1.5);
  EXPECT_EQ(capsule.bounds.min.z, -1.5);
  EXPECT_NEAR(volume(capsule), M_PI * 0.25 * 2 + 4.0 / 3 * M_PI * 0.125, 0.03);
}

TEST(Shapes, HaveTheSameBitsOnEveryMachine) {
  Sha256 hash;
  for (const Mesh& mesh :
       {boxMesh({1, 2, 3}), cylinderMesh(0.5, 2), sphereMesh(2), capsuleMesh(0.5, 2)}) {
    hash.add(std::as_bytes(std::span(mesh.vertices)));
    hash.add(std::as_bytes(std::span(mesh.indices)));
  }
  EXPECT_EQ(hexOf(hash.finish()),
            "a624664988760384581c3e5ac75cfd8e814348f7d96fe71eca4ba03ca0edbfba");
}

}  // namespace
}  // namespace rocinante
