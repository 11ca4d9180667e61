#include "core/clearance/tree_distance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/clearance/random_bodies.h"

namespace rocinante {
namespace {

Triangle placedAt(const Mat4& placement, const Triangle& triangle) {
  return {transformPoint(placement, triangle[0]), transformPoint(placement, triangle[1]),
          transformPoint(placement, triangle[2])};
}

/// Every solid with every other.
double bruteForce(const std::vector<Solid>& a, const std::vector<Solid>& b, const Mat4& a_in_b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Solid& x : a) {
    const Triangle at = placedAt(a_in_b, x.triangle);
    for (const Solid& y : b) {
      const double apart = triangleDistance(at, y.triangle).distance_m - (x.radius_m + y.radius_m);
      least = std::min(least, apart < kTouching_m ? 0.0 : apart);
    }
  }
  return least;
}

TEST(TreeDistance, GivesTheDistanceOfBruteForceToTheBitAtRandomPoses) {
  test::Random random(7);
  int touching = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Solid> a = random.solids(37), b = random.solids(61);
    const TriangleTree tree_a(a), tree_b(b);
    const Mat4 placement = random.placement(1.2);
    const double expected = bruteForce(a, b, placement);
    const TreeContact contact = treeDistance(tree_a, tree_b, placement);
    EXPECT_EQ(contact.distance_m, expected);
    if (expected > 0) {
      EXPECT_NEAR(lengthOf(contact.on_a - contact.on_b), expected, 1e-12);
    }
    touching += expected > 0 ? 0 : 1;
    // Wherever the search begins.
    TreeContact elsewhere;
    elsewhere.solid_a = 11;
    elsewhere.solid_b = 3;
    EXPECT_EQ(treeDistance(tree_a, tree_b, placement, &elsewhere).distance_m, expected);
  }
  EXPECT_GT(touching, 5);
  EXPECT_LT(touching, 55);
}

TEST(TreeDistance, OneSearchAfterAnotherGivesTheSameBitsAndItsBoundHolds) {
  test::Random random(29);
  TreeSearch search;
  TreeContact known;
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Solid> a = random.solids(round % 2 == 0 ? 90 : 300), b = random.solids(120);
    const TriangleTree tree_a(a), tree_b(b);
    const Mat4 placement = random.placement(2);
    const double expected = bruteForce(a, b, placement);
    constexpr double kAny = std::numeric_limits<double>::infinity();
    known = search.bounded(tree_a, tree_b, placement, {kAny, kAny}, &known).contact;
    EXPECT_EQ(known.distance_m, expected);
    // Only whether it is below half a metre.
    const BoundedDistance rough = search.bounded(tree_a, tree_b, placement, {0.5, 0}, nullptr);
    EXPECT_EQ(rough.contact.distance_m < 0.5, expected < 0.5);
    EXPECT_GE(rough.contact.distance_m, expected);
    EXPECT_LE(rough.at_least_m, expected + 1e-12);
  }
}

TEST(TreeDistance, SpheresAndCapsulesAreExact) {
  const TriangleTree ball({{{Vec3(0), Vec3(0), Vec3(0)}, 0.25}});
  EXPECT_DOUBLE_EQ(treeDistance(ball, ball, translationMatrix({3, 4, 0})).distance_m, 4.5);
  EXPECT_EQ(treeDistance(ball, ball, translationMatrix({0.3, 0, 0})).distance_m, 0);
  const TriangleTree rod({{{Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(0, 0, 1)}, 0.1}});
  EXPECT_NEAR(treeDistance(ball, rod, translationMatrix({1, 0, 0.7})).distance_m, 0.65, 1e-15);
  EXPECT_NEAR(treeDistance(ball, rod, translationMatrix({0, 0, 2})).distance_m, 0.65, 1e-15);
  const TreeContact contact = treeDistance(ball, rod, translationMatrix({1, 0, 0.7}));
  EXPECT_NEAR(contact.on_a.x, 0.75, 1e-15);
  EXPECT_NEAR(contact.on_b.x, 0.1, 1e-15);
}

TEST(TreeDistance, AnEmptyOneIsInfinitelyFar) {
  const TriangleTree none({}), ball({{{Vec3(0), Vec3(0), Vec3(0)}, 1}});
  EXPECT_EQ(treeDistance(none, ball, Mat4{1.0}).distance_m,
            std::numeric_limits<double>::infinity());
  TreeContact least;
  EXPECT_FALSE(TreeSearch().sweep(ball, none, {}, 1, 1e-3, least));
}

TEST(TreeDistance, ASweepFindsTheLeastOfItsEndsAndAsksForMoreWhereBetweenIsNearer) {
  const TriangleTree ball({{{Vec3(0), Vec3(0), Vec3(0)}, 0.25}});
  TreeContact least;
  // Past another at 0.1: nearest in the middle.
  const TreeSweep past{translationMatrix({-1, 0.6, 0}), translationMatrix({1, 0.6, 0}), 0};
  EXPECT_TRUE(TreeSearch().sweep(ball, ball, past, 1, 1e-3, least));
  EXPECT_NEAR(least.distance_m, std::sqrt(1.36) - 0.5, 1e-12);
  // Away from it: nearest at its start.
  least = {};
  const TreeSweep away{translationMatrix({1, 0, 0}), translationMatrix({2, 0, 0}), 0};
  EXPECT_FALSE(TreeSearch().sweep(ball, ball, away, 1, 1e-3, least));
  EXPECT_DOUBLE_EQ(least.distance_m, 0.5);
  EXPECT_FALSE(least.at_end);
  // Farther than what matters.
  least = {};
  EXPECT_FALSE(TreeSearch().sweep(ball, ball, away, 0.3, 1e-3, least));
}

TEST(TreeDistance, DisplacementBoundsThatOfEveryPoint) {
  test::Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Mat4 from = random.placement(1), to = random.placement(1);
    const Vec3 centre = random.point(1), point = random.point(0.5);
    const double bound = displacement(from, to, centre, lengthOf(point));
    const Vec3 moved = transformPoint(to, centre + point) - transformPoint(from, centre + point);
    EXPECT_LE(lengthOf(moved), bound + 1e-12);
  }
}

}  // namespace
}  // namespace rocinante
