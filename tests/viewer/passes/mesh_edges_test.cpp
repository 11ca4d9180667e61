#include "viewer/passes/mesh_edges.h"

#include <gtest/gtest.h>

#include "core/mesh/shapes.h"

namespace rocinante {
namespace {

TEST(MeshEdges, ABoxHasTwelveCreasesAndSixFlatDiagonals) {
  const MeshEdges edges = meshEdges(boxMesh({1, 2, 3}));
  ASSERT_EQ(edges.parts.size(), 1U);
  EXPECT_EQ(edges.parts[0].features, 12U);
  EXPECT_EQ(edges.parts[0].all, 18U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(edges.edges[i].first_normal, glm::vec3(0)) << "a crease is always drawn";
  }
}

/// Two triangles that share the side from (0, 0, 0) to (0, 1, 0); the second is turned up by
/// `rise` over a unit.
Mesh hinge(float rise, bool second_reversed) {
  Mesh mesh;
  for (const glm::vec3& at :
       {glm::vec3(0, 0, 0), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0), glm::vec3(1, 0, rise)}) {
    mesh.vertices.push_back({at, {0, 0, 1}, {}});
  }
  mesh.indices = {0, 1, 2, 1, 0, 3};
  if (second_reversed) std::swap(mesh.indices[3], mesh.indices[4]);
  mesh.parts = {{"hinge", 0, 0, 6}};
  mesh.materials.resize(1);
  return mesh;
}

TEST(MeshEdges, ASmoothEdgeKeepsBothNormalsWhicheverWayItsTrianglesTurn) {
  for (const bool reversed : {false, true}) {
    const MeshEdges edges = meshEdges(hinge(0.3F, reversed));
    EXPECT_EQ(edges.parts[0].features, 5U);
    int smooth = 0;
    for (const MeshEdge& edge : edges.edges) {
      if (edge.first_normal == glm::vec3(0)) continue;
      ++smooth;
      const glm::vec3& n = edge.second_normal;
      EXPECT_GT(n.x * edge.first_normal.x + n.y * edge.first_normal.y + n.z * edge.first_normal.z,
                0.9F);
    }
    EXPECT_EQ(smooth, 1);
  }
}

TEST(MeshEdges, WhatIsFlatIsNoFeatureAndWhatTurnsMoreThanThirtyDegreesIsACrease) {
  EXPECT_EQ(meshEdges(hinge(0, false)).parts[0].features, 4U);
  const MeshEdges crease = meshEdges(hinge(0.7F, false));
  EXPECT_EQ(crease.parts[0].features, 5U);
  for (const MeshEdge& edge : crease.edges) EXPECT_EQ(edge.first_normal, glm::vec3(0));
}

TEST(MeshEdges, AFaceWrittenForBothItsSidesCountsOnce) {
  Mesh mesh = hinge(0, false);
  const std::vector<std::uint32_t> once = mesh.indices;
  for (std::size_t i = 0; i < once.size(); i += 3) {
    mesh.indices.insert(mesh.indices.end(), {once[i + 2], once[i + 1], once[i]});
  }
  mesh.parts[0].index_count = 12;
  EXPECT_EQ(meshEdges(mesh).parts[0].features, 4U);
}

TEST(MeshEdges, GroupsHaveEdgesOfTheirOwnAndMaterialsShareThem) {
  Mesh mesh = hinge(0, false);
  mesh.parts = {{"a", 0, 0, 3}, {"b", 0, 3, 3}};
  MeshEdges edges = meshEdges(mesh);
  EXPECT_EQ(edges.parts[0].features + edges.parts[1].features, 6U);
  EXPECT_EQ(edges.parts[1].first, 3U);
  mesh.parts = {{"a", 0, 0, 3}, {"a", 0, 3, 3}};
  edges = meshEdges(mesh);
  EXPECT_EQ(edges.parts[0].features + edges.parts[1].features, 4U);
}

TEST(MeshEdges, KnowHowWideTheirFacesAre) {
  // A bar of 2 m with sides of 0.1 and 0.2 m: each edge has a side of about 0.2 m beside it, but
  // those along its ends' shorter borders, which have the narrow sides.
  for (const MeshEdge& edge : meshEdges(boxMesh({0.1, 0.2, 2})).edges) {
    EXPECT_GT(edge.face_width, 0.05F);
    EXPECT_LT(edge.face_width, 0.2F);
  }
  // Cut into a hundred strips, which are one face.
  Mesh strips;
  for (int i = 0; i <= 100; ++i) {
    for (const float y : {0.0F, 1.0F}) {
      Vertex vertex;
      vertex.position = {static_cast<float>(i) * 0.01F, y, 0};
      strips.vertices.push_back(vertex);
    }
  }
  for (std::uint32_t i = 0; i < 200; i += 2) {
    strips.indices.insert(strips.indices.end(), {i, i + 2, i + 3, i, i + 3, i + 1});
  }
  strips.parts.push_back({"", 0, 0, 600});
  for (const MeshEdge& edge : meshEdges(strips).edges) EXPECT_NEAR(edge.face_width, 0.41F, 0.01F);
  // A pipe, whose edges are its outlines and two rings.
  for (const MeshEdge& edge : meshEdges(cylinderMesh(0.05, 4)).edges) {
    EXPECT_GT(edge.face_width, 0.03F);
    EXPECT_LT(edge.face_width, 0.15F);
  }
}

TEST(MeshEdges, SliversAndNothingAtAllAreNoTrouble) {
  Mesh mesh = hinge(0, false);
  mesh.vertices[3].position = {0, 0.5F, 0};  // on the shared side
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1});
  mesh.parts[0].index_count = 9;
  EXPECT_EQ(meshEdges(mesh).parts[0].all, 5U);
  EXPECT_TRUE(meshEdges(Mesh{}).edges.empty());
}

}  // namespace
}  // namespace rocinante
