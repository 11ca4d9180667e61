#include "core/clearance/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/clearance/tree_distance.h"
#include "tests/core/clearance/random_bodies.h"

namespace rocinante {
namespace {

using Solids = std::vector<Solid>;

/// The surface of a box whose sides are `half` from its middle, facing outwards.
Solids boxOf(const Vec3& middle, double half) {
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  const auto corner = [&](int i) {
    return middle + Vec3((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                         (i & 4) != 0 ? half : -half);
  };
  Solids solids;
  for (const auto& face : kFaces) {
    const Vec3 a = corner(face[0]), b = corner(face[1]), c = corner(face[2]), d = corner(face[3]);
    solids.push_back({{a, b, c}, 0});
    solids.push_back({{a, c, d}, 0});
  }
  return solids;
}

Solids turnedRound(Solids solids) {
  for (Solid& solid : solids) std::swap(solid.triangle[1], solid.triangle[2]);
  return solids;
}

Solids both(Solids a, const Solids& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Solids ballOf(const Vec3& middle, double radius) { return {{{middle, middle, middle}, radius}}; }

double apart(const Solids& a, const Solids& b, const Mat4& a_in_b = Mat4(1.0)) {
  return treeDistance(TriangleTree(a), TriangleTree(b), a_in_b).distance_m;
}

TEST(Enclosure, ABoxInABoxPenetratesWhicheverIsAsked) {
  const Solids outer = boxOf({0, 0, 0}, 1), inner = boxOf({0.2, 0.1, -0.1}, 0.3);
  EXPECT_EQ(apart(inner, outer), 0);
  EXPECT_EQ(apart(outer, inner), 0);
  EXPECT_EQ(apart(inner, turnedRound(outer)), 0) << "all of it facing inwards is closed, too";
  EXPECT_DOUBLE_EQ(apart(inner, outer, translationMatrix({2, 0, 0})), 0.9);
  const TreeContact contact = treeDistance(TriangleTree(inner), TriangleTree(outer), Mat4(1.0));
  EXPECT_EQ(contact.on_a, contact.on_b);
  EXPECT_TRUE(encloses(TriangleTree(outer), contact.on_a));
}

TEST(Enclosure, SpheresAreSolidAndLieInBoxes) {
  const Solids box = boxOf({0, 0, 0}, 1);
  EXPECT_EQ(apart(ballOf({0, 0, 0}, 0.2), box), 0);
  EXPECT_EQ(apart(box, ballOf({0, 0, 0}, 0.2)), 0);
  EXPECT_EQ(apart(boxOf({0, 0, 0}, 0.1), ballOf({0, 0, 0}, 1)), 0) << "the box in the sphere";
  EXPECT_DOUBLE_EQ(apart(ballOf({0, 0, 1.5}, 0.2), box), 0.3);
}

TEST(Enclosure, AnOpenBodyEnclosesNothing) {
  Solids open = boxOf({0, 0, 0}, 1);
  open.pop_back();
  EXPECT_FALSE(partsOf(open).any_closed);
  EXPECT_NEAR(apart(ballOf({0, 0, 0}, 0.2), open), 0.8, 1e-12);
  // Beside a closed part of the same body, which stays closed.
  const Solids two = both(open, boxOf({3, 0, 0}, 1));
  EXPECT_NEAR(apart(ballOf({0, 0, 0}, 0.2), two), 0.8, 1e-12);
  EXPECT_EQ(apart(ballOf({3, 0, 0}, 0.2), two), 0);
  Solids mixed = boxOf({0, 0, 0}, 1);
  std::swap(mixed[3].triangle[1], mixed[3].triangle[2]);
  EXPECT_FALSE(partsOf(mixed).any_closed) << "one triangle faces the other way";
}

TEST(Enclosure, AHollowIsOutsideAndWhatOverlapsIsInside) {
  const Solids tank = both(boxOf({0, 0, 0}, 1), turnedRound(boxOf({0, 0, 0}, 0.9)));
  EXPECT_NEAR(apart(ballOf({0, 0, 0}, 0.2), tank), 0.7, 1e-12);
  EXPECT_EQ(apart(ballOf({0.95, 0, 0}, 0.01), tank), 0) << "in its wall";
  const Solids overlapping = both(boxOf({0, 0, 0}, 1), boxOf({0.5, 0, 0}, 1));
  EXPECT_EQ(apart(ballOf({0.25, 0, 0}, 0.1), overlapping), 0);
}

TEST(Enclosure, OnePartOfManyInsideIsEnough) {
  const Solids parts = both(boxOf({5, 0, 0}, 0.1), boxOf({0, 0, 0}, 0.1));
  EXPECT_EQ(partsOf(parts).points.size(), 2U);
  EXPECT_EQ(apart(parts, boxOf({0, 0, 0}, 1)), 0);
  EXPECT_EQ(apart(boxOf({0, 0, 0}, 1), parts), 0);
}

TEST(Enclosure, DegenerateTrianglesDoNotMatter) {
  Solids box = boxOf({0, 0, 0}, 1);
  const Vec3 corner = box[0].triangle[0], next = box[0].triangle[1];
  box.push_back({{corner, corner, corner}, 0});
  box.push_back({{corner, next, next}, 0});
  EXPECT_EQ(apart(ballOf({0.1, 0.2, 0.3}, 0.05), box), 0);
}

TEST(Enclosure, AgreesWithTheBoxAtRandomPoints) {
  test::Random random(17);
  const TriangleTree tree(boxOf({0.1, 0.2, 0.3}, 0.5));
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    // Every other one on a grid, where rays along the axes would meet edges.
    Vec3 point = random.point(1);
    if (i % 2 == 0) {
      for (int axis = 0; axis < 3; ++axis) point[axis] = std::round(point[axis] * 8) / 8;
    }
    const Vec3 from = point - Vec3(0.1, 0.2, 0.3);
    const double far = std::max({std::fabs(from.x), std::fabs(from.y), std::fabs(from.z)});
    EXPECT_EQ(encloses(tree, point), far < 0.5) << point.x << " " << point.y << " " << point.z;
    inside += far < 0.5 ? 1 : 0;
  }
  EXPECT_GT(inside, 300);
}

}  // namespace
}  // namespace rocinante
