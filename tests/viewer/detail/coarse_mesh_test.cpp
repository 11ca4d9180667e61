#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/shapes.h"
#include "tests/viewer/detail/test_meshes.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante {
namespace {

Mesh hills() {
  return test::sheetMesh(64, 2, [](double u, double v) { return 0.05 * std::sin(9 * u) * v; });
}

TEST(CoarseMesh, HalvesItsTrianglesAndKeepsItsParts) {
  const Mesh whole = hills();
  std::size_t before = whole.triangleCount();
  for (int halvings = 1; halvings <= 3; ++halvings) {
    const Mesh coarse = coarseMesh(whole, halvings);
    EXPECT_LT(coarse.triangleCount(), before * 6 / 10) << halvings;
    before = coarse.triangleCount();
    ASSERT_EQ(coarse.parts.size(), 2U);
    std::uint32_t end = 0;
    for (const MeshPart& part : coarse.parts) {
      EXPECT_EQ(part.first_index, end);
      EXPECT_GT(part.index_count, 0U);
      end += part.index_count;
    }
    EXPECT_EQ(end, coarse.indices.size());
  }
}

TEST(CoarseMesh, HasNoVertexThatNoTriangleHas) {
  Mesh whole = hills();
  whole.colors.resize(whole.vertices.size());
  for (std::size_t i = 0; i < whole.colors.size(); ++i) {
    whole.colors[i] = static_cast<std::uint32_t>(i);
  }
  const Mesh coarse = coarseMesh(whole, 2);
  std::vector<bool> used(coarse.vertices.size());
  for (const std::uint32_t index : coarse.indices) used.at(index) = true;
  EXPECT_EQ(std::ranges::count(used, false), 0);
  ASSERT_EQ(coarse.colors.size(), coarse.vertices.size());
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
    EXPECT_EQ(coarse.vertices[i].position, whole.vertices[coarse.colors[i]].position);
  }
}

TEST(CoarseMesh, LeavesWhatIsSmallOrAShape) {
  const Mesh sheet = test::sheetMesh(4, 1, [](double, double) { return 0.0; });
  EXPECT_EQ(coarseMesh(sheet, 5).indices, sheet.indices);
  EXPECT_EQ(coarseMesh(hills(), 0).indices, hills().indices);
  Mesh shape = hills();
  shape.shape.emplace();
  EXPECT_EQ(coarseMesh(shape, 3).indices, shape.indices);
}

}  // namespace
}  // namespace rocinante
