#include "viewer/detail/mesh_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/viewer/detail/test_meshes.h"

namespace rocinante {
namespace {

using test::hillsMesh;
using test::inputOf;

TEST(MeshDetail, HalvesAgainAndAgainWithGrowingErrors) {
  const Mesh mesh = hillsMesh(100);
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  ASSERT_EQ(detail.parts.size(), 1U);
  const auto& versions = detail.parts[0];
  ASSERT_GE(versions.size(), 3U);
  std::size_t before = mesh.indices.size();
  double error = 0;
  for (const CoarsePart& version : versions) {
    EXPECT_LT(version.two_sided_count, before * 8 / 10);
    EXPECT_EQ(version.two_sided_count % 3, 0U);
    EXPECT_EQ(version.one_sided_count, 0U);
    EXPECT_GT(version.error_m, error);
    before = version.two_sided_count;
    error = version.error_m;
  }
  EXPECT_LT(error, 0.06);  // a twentieth of a metre, but for rounding
}

/// The height of a coarse version's surface over (x, y); the sheet is a graph over the plane.
double heightOver(const Mesh& mesh, std::span<const std::uint32_t> indices, double x, double y) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[indices[i]].position);
    const Vec3 b(mesh.vertices[indices[i + 1]].position);
    const Vec3 c(mesh.vertices[indices[i + 2]].position);
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0) continue;
    const double s = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
    const double t = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
    if (s >= -1e-9 && t >= -1e-9 && s + t <= 1 + 1e-9)
      return a.z + s * (b.z - a.z) + t * (c.z - a.z);
  }
  return NAN;
}

TEST(MeshDetail, TheSurfaceStaysWithinTheErrorThatIsNamed) {
  const Mesh mesh = hillsMesh(48);
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  const std::span<const std::uint32_t> all(detail.indices);
  for (const CoarsePart& version : detail.parts[0]) {
    const auto run = all.subspan(version.first_index, version.two_sided_count);
    double worst = 0;
    for (int i = 1; i < 20; ++i) {
      for (int j = 1; j < 20; ++j) {
        const double x = i / 20.0, y = j / 20.0;
        const double height = heightOver(mesh, run, x, y);
        ASSERT_TRUE(std::isfinite(height)) << "a hole at " << x << ", " << y;
        worst = std::max(worst, std::abs(height - heightOver(mesh, mesh.indices, x, y)));
      }
    }
    // The error is a root of mean squares over planes, not a bound of every point: some slack.
    EXPECT_LT(worst, 3 * version.error_m + 1e-4) << version.two_sided_count / 3 << " triangles";
  }
}

TEST(MeshDetail, NothingMovesWherePartsMeet) {
  const Mesh mesh = hillsMesh(60, 3);
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  ASSERT_EQ(detail.parts.size(), 3U);
  // Every vertex of the line x = 1/3 is still used by both neighbours, however coarse: no crack.
  for (const std::size_t part : {0U, 1U}) {
    ASSERT_FALSE(detail.parts[part].empty());
    for (const CoarsePart& version : detail.parts[part]) {
      std::set<std::uint32_t> on_line;
      for (std::uint32_t i = 0; i < version.two_sided_count; ++i) {
        const std::uint32_t index = detail.indices[version.first_index + i];
        if (std::abs(mesh.vertices[index].position.x - 1.0F / 3) < 1e-6F) on_line.insert(index);
      }
      EXPECT_EQ(on_line.size(), 61U);
    }
  }
}

TEST(MeshDetail, VerticesAlongASeamStayTogether) {
  // The sheet, cut along x = 1/2 into two halves of the texture: vertices there stand twice.
  Mesh mesh = hillsMesh(40);
  std::map<std::uint32_t, std::uint32_t> doubled;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto x = [&](std::size_t corner) {
      return mesh.vertices[mesh.indices[corner]].position.x;
    };
    if (std::max({x(i), x(i + 1), x(i + 2)}) <= 0.5F) continue;
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      if (x(corner) != 0.5F) continue;
      std::uint32_t& index = mesh.indices[corner];
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      const auto [copy, fresh] = doubled.emplace(index, next);
      if (fresh) {
        mesh.vertices.push_back(mesh.vertices[index]);
        mesh.vertices.back().texture.x += 7;
      }
      index = copy->second;
    }
  }
  ASSERT_EQ(doubled.size(), 41U);
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  ASSERT_FALSE(detail.parts[0].empty());
  const CoarsePart& coarsest = detail.parts[0].back();
  std::set<float> left, right;
  for (std::uint32_t i = 0; i < coarsest.two_sided_count; i += 3) {
    bool old_half = false, new_half = false;
    for (std::uint32_t corner = i; corner < i + 3; ++corner) {
      const Vertex& vertex = mesh.vertices[detail.indices[coarsest.first_index + corner]];
      (vertex.texture.x > 2 || vertex.position.x > 0.5F ? new_half : old_half) |=
          vertex.position.x != 0.5F || vertex.texture.x > 2;
      if (vertex.position.x == 0.5F) {
        (vertex.texture.x > 2 ? right : left).insert(vertex.position.y);
      }
    }
    EXPECT_FALSE(old_half && new_half) << "a triangle across the seam";
  }
  EXPECT_EQ(left, right);
  EXPECT_LT(left.size(), 41U) << "the seam itself is made coarser too";
}

TEST(MeshDetail, OneSidedTrianglesStayLastAndApart) {
  const Mesh mesh = hillsMesh(40);
  DetailInput input = inputOf(mesh);
  input.one_sided_counts[0] = static_cast<std::uint32_t>(mesh.indices.size() / 2);
  const MeshDetail detail = makeMeshDetail(input);
  ASSERT_FALSE(detail.parts[0].empty());
  const CoarsePart& coarsest = detail.parts[0].back();
  EXPECT_GT(coarsest.two_sided_count, 0U);
  EXPECT_GT(coarsest.one_sided_count, 0U);
  for (std::uint32_t i = 0; i < coarsest.one_sided_count; ++i) {
    const std::uint32_t index = detail.indices[coarsest.first_index + coarsest.two_sided_count + i];
    EXPECT_GE(mesh.vertices[index].position.y, 0.5F - 1e-6F);
  }
}

TEST(MeshDetail, FewTrianglesHaveNoCoarserVersion) {
  const Mesh mesh = hillsMesh(4);
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  ASSERT_EQ(detail.parts.size(), 1U);
  EXPECT_TRUE(detail.parts[0].empty());
  EXPECT_TRUE(detail.indices.empty());
  EXPECT_TRUE(makeMeshDetail(inputOf(Mesh{})).parts.empty());
}

TEST(MeshDetail, TheSameMeshGivesTheSameBitsAndAnotherAnotherKey) {
  const Mesh mesh = hillsMesh(40, 2);
  EXPECT_EQ(makeMeshDetail(inputOf(mesh)), makeMeshDetail(inputOf(mesh)));
  const std::string key = detailKey(inputOf(mesh));
  EXPECT_EQ(key.size(), 32U);
  EXPECT_EQ(detailKey(inputOf(hillsMesh(40, 2))), key);
  Mesh moved = mesh;
  moved.vertices[7].position.z += 1e-6F;
  EXPECT_NE(detailKey(inputOf(moved)), key);
  Mesh otherwise = mesh;
  std::swap(otherwise.indices[0], otherwise.indices[1]);
  EXPECT_NE(detailKey(inputOf(otherwise)), key);
  DetailInput sided = inputOf(mesh);
  sided.one_sided_counts[0] = 3;
  EXPECT_NE(detailKey(sided), key);
}

TEST(MeshDetail, DegenerateAndWildTrianglesAreBorne) {
  Mesh mesh = hillsMesh(20);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 7) mesh.indices[i] = 0;
  mesh.vertices[3].position = {1e30F, -1e30F, 0};
  mesh.vertices[9].position = {NAN, INFINITY, 0};
  const MeshDetail detail = makeMeshDetail(inputOf(mesh));
  for (const std::uint32_t index : detail.indices) EXPECT_LT(index, mesh.vertices.size());
}

}  // namespace
}  // namespace rocinante
