#include "viewer/cull/coplanar_surfaces.h"

#include <gtest/gtest.h>

#include "tests/viewer/support/test_scene.h"

namespace rocinante {
namespace {

/// Squares as parts of one mesh: centre, size, and whether it looks along +y instead of -y.
struct Square {
  Vec3 center;
  double size;
  bool reversed = false;
};

Mesh meshOf(const std::vector<Square>& squares) {
  Mesh mesh;
  for (const Square& square : squares) {
    const Mesh one = test::squareMesh(square.size);
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto first_index = static_cast<std::uint32_t>(mesh.indices.size());
    for (Vertex vertex : one.vertices) {
      vertex.position += glm::vec3(square.center);
      mesh.bounds.add(Vec3(vertex.position));
      mesh.vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i < one.indices.size(); i += 3) {
      const std::size_t b = square.reversed ? i + 2 : i + 1;
      const std::size_t c = square.reversed ? i + 1 : i + 2;
      for (const std::size_t at : {i, b, c}) {
        mesh.indices.push_back(first_vertex + one.indices[at]);
      }
    }
    mesh.parts.push_back({"part", 0, first_index, 6});
  }
  mesh.materials = {Material{}};
  return mesh;
}

using Ranks = std::vector<std::uint32_t>;

TEST(CoplanarSurfaces, TheWindowStandsAboveItsWallWhicheverComesFirst) {
  const Square wall{{0, 0, 0}, 10};
  const Square window{{1, 0, 1}, 1};
  EXPECT_EQ(coplanarSurfaces(meshOf({wall, window})).ranks, (Ranks{0, 1}));
  EXPECT_EQ(coplanarSurfaces(meshOf({window, wall})).ranks, (Ranks{1, 0}));
}

TEST(CoplanarSurfaces, APosterOnTheWindowOnTheWallIsOneHigherStill) {
  EXPECT_EQ(coplanarSurfaces(meshOf({{{0, 0, 0}, 10}, {{1, 0, 1}, 2}, {{1, 0, 1}, 1}})).ranks,
            (Ranks{0, 1, 2}));
}

TEST(CoplanarSurfaces, NeighboursThatShareAnEdgeDoNotOverlap) {
  EXPECT_EQ(coplanarSurfaces(meshOf({{{0, 0, 0}, 2}, {{2, 0, 0}, 2}})).ranks, (Ranks{0, 0}));
}

TEST(CoplanarSurfaces, ParallelPlanesApartDoNotOverlap) {
  EXPECT_EQ(coplanarSurfaces(meshOf({{{0, 0, 0}, 10}, {{0, 0.01, 0}, 1}})).ranks, (Ranks{0, 0}));
}

TEST(CoplanarSurfaces, RoundingOfThePlaneDoesNotHideAnOverlap) {
  for (int i = 0; i < 200; ++i) {
    const double y = 3.0 + i * 1.37e-5;
    SCOPED_TRACE(y);
    EXPECT_EQ(coplanarSurfaces(meshOf({{{0, y, 0}, 10}, {{1, y + 1e-6, 1}, 1}})).ranks,
              (Ranks{0, 1}));
  }
}

TEST(CoplanarSurfaces, EqualAreasGoByTheOrderOfTheFile) {
  EXPECT_EQ(coplanarSurfaces(meshOf({{{0, 0, 0}, 2}, {{0.5, 0, 0.5}, 2}})).ranks, (Ranks{0, 1}));
}

TEST(CoplanarSurfaces, AFaceAndItsBackAreEachSeenFromTheirFront) {
  const CoplanarSurfaces surfaces =
      coplanarSurfaces(meshOf({{{0, 0, 0}, 2}, {{0, 0, 0}, 2, true}, {{9, 0, 0}, 2}}));
  EXPECT_EQ(surfaces.ranks, (Ranks{0, 0, 0}));
  EXPECT_EQ(surfaces.one_sided, (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0}));
  EXPECT_TRUE(surfaces.any_one_sided);
}

TEST(CoplanarSurfaces, ADoorThatLeavesItsFrameIsSeenFromBothSides) {
  const Mesh mesh = meshOf({{{0, 0, 0}, 4}, {{0, 0, 0}, 2, true}});
  EXPECT_TRUE(coplanarSurfaces(mesh, {7, 7}).any_one_sided);
  EXPECT_FALSE(coplanarSurfaces(mesh, {1, 2}).any_one_sided);
}

TEST(CoplanarSurfaces, RanksAreBounded) {
  std::vector<Square> stack;
  for (int i = 0; i < 40; ++i) stack.push_back({{0, 0, 0}, 10.0 - i * 0.1});
  EXPECT_EQ(coplanarSurfaces(meshOf(stack)).ranks.back(), 15U);
}

TEST(CoplanarSurfaces, EmptyAndDegenerateMeshesAreLeftAlone) {
  EXPECT_TRUE(coplanarSurfaces(Mesh{}).ranks.empty());
  EXPECT_EQ(coplanarSurfaces(meshOf({{{0, 0, 0}, 0}, {{0, 0, 0}, 0}})).ranks, (Ranks{0, 0}));
}

}  // namespace
}  // namespace rocinante
