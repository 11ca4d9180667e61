#include "core/clearance/triangle_distance.h"

#include <gtest/gtest.h>

#include "tests/core/clearance/random_bodies.h"

namespace rocinante {
namespace {

const Triangle kFlat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

Triangle moved(Triangle triangle, const Vec3& by) {
  for (Vec3& corner : triangle) corner += by;
  return triangle;
}

/// The least distance of a fine grid of points on both: never below the true one, and above it by
/// at most a grid's step each.
double gridDistance(const Triangle& a, const Triangle& b, int steps) {
  const auto point = [steps](const Triangle& t, int i, int j) {
    const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
    return t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v;
  };
  double least = 1e300;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Vec3 on_a = point(a, i, j);
      for (int k = 0; k <= steps; ++k) {
        for (int l = 0; k + l <= steps; ++l) {
          least = std::min(least, lengthOf(on_a - point(b, k, l)));
        }
      }
    }
  }
  return least;
}

TEST(TriangleDistance, IsBetweenFacesEdgesAndCorners) {
  EXPECT_DOUBLE_EQ(triangleDistance(kFlat, moved(kFlat, {0, 0, 0.25})).distance_m, 0.25);
  EXPECT_DOUBLE_EQ(triangleDistance(kFlat, moved(kFlat, {3, 0, 0})).distance_m, 2);
  // A corner above the middle of the face.
  const Triangle above{Vec3(0.2, 0.2, 0.5), Vec3(0, 0, 2), Vec3(1, 0, 2)};
  const NearestPoints nearest = triangleDistance(kFlat, above);
  EXPECT_DOUBLE_EQ(nearest.distance_m, 0.5);
  EXPECT_EQ(nearest.on_a, Vec3(0.2, 0.2, 0));
  EXPECT_EQ(nearest.on_b, Vec3(0.2, 0.2, 0.5));
  // Two edges that pass each other.
  const Triangle beam{Vec3(0.2, -1, 0.1), Vec3(0.2, 1, 0.1), Vec3(0.2, 0, 3)};
  const Triangle cross{Vec3(-1, 0, -0.2), Vec3(1, 0, -0.2), Vec3(0, 0, -3)};
  EXPECT_NEAR(triangleDistance(beam, cross).distance_m, 0.3, 1e-15);
}

TEST(TriangleDistance, IsZeroWhereTrianglesTouchCrossOrLieInEachOther) {
  EXPECT_EQ(triangleDistance(kFlat, kFlat).distance_m, 0);
  const Triangle through{Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 1), Vec3(0.3, 0.3, 1)};
  const NearestPoints crossing = triangleDistance(kFlat, through);
  EXPECT_EQ(crossing.distance_m, 0);
  EXPECT_EQ(crossing.on_a, crossing.on_b);
  EXPECT_NEAR(crossing.on_a.z, 0, 1e-15);
  // Flat inside another, and only a corner touching it.
  const Triangle inside{Vec3(0.2, 0.2, 0), Vec3(0.3, 0.2, 0), Vec3(0.2, 0.3, 0)};
  EXPECT_EQ(triangleDistance(kFlat, inside).distance_m, 0);
  EXPECT_EQ(triangleDistance(inside, kFlat).distance_m, 0);
  const Triangle corner{Vec3(0.2, 0.2, 0), Vec3(0, 0, 1), Vec3(1, 0, 1)};
  EXPECT_EQ(triangleDistance(kFlat, corner).distance_m, 0);
}

TEST(TriangleDistance, TakesSegmentsAndPointsForTriangles) {
  const Triangle point{Vec3(0.2, 0.2, 2), Vec3(0.2, 0.2, 2), Vec3(0.2, 0.2, 2)};
  EXPECT_DOUBLE_EQ(triangleDistance(kFlat, point).distance_m, 2);
  EXPECT_DOUBLE_EQ(triangleDistance(point, moved(point, {0, 3, 4})).distance_m, 5);
  const Triangle segment{Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, 3), Vec3(0.2, 0.2, 3)};
  EXPECT_DOUBLE_EQ(triangleDistance(segment, kFlat).distance_m, 1);
  EXPECT_EQ(triangleDistance(moved(segment, {0, 0, -2}), kFlat).distance_m, 0);
  const Triangle flat_line{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(2, 0, 1)};
  EXPECT_DOUBLE_EQ(triangleDistance(flat_line, kFlat).distance_m, 1);
}

TEST(TriangleDistance, IsNeitherAboveNorFarBelowThatOfAFineGrid) {
  test::Random random(1);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    const Triangle a = random.triangle(1), b = moved(random.triangle(1), random.point(1.5));
    const NearestPoints nearest = triangleDistance(a, b);
    const double grid = gridDistance(a, b, 12);
    EXPECT_LE(nearest.distance_m, grid + 1e-12);
    EXPECT_GE(nearest.distance_m, grid - 2 * 3.5 / 12);
    EXPECT_NEAR(lengthOf(nearest.on_a - nearest.on_b), nearest.distance_m, 1e-12);
    EXPECT_EQ(triangleDistance(b, a).distance_m > 0, nearest.distance_m > 0);
    EXPECT_NEAR(triangleDistance(b, a).distance_m, nearest.distance_m, 1e-12);
    // The points lie on the triangles.
    const Triangle on_a{nearest.on_a, nearest.on_a, nearest.on_a};
    const Triangle on_b{nearest.on_b, nearest.on_b, nearest.on_b};
    EXPECT_NEAR(triangleDistance(on_a, a).distance_m, 0, 1e-12);
    EXPECT_NEAR(triangleDistance(on_b, b).distance_m, 0, 1e-12);
  }
}

}  // namespace
}  // namespace rocinante
