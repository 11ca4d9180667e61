#include "core/clearance/aimed_tree.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/clearance/random_bodies.h"

namespace rocinante {
namespace {

/// That every corner of the solids below a node is in the node's extent, at `share` of the way.
void expectHolds(const TriangleTree& tree, AimedTree& aimed, const Aim& aim,
                 const std::array<Mat4, 2>& places, double share) {
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const TriangleTree::Node& node = tree.nodes()[i];
    for (std::uint32_t j = node.first; node.count > 0 && j < node.first + node.count; ++j) {
      const Extent extent = aimed.ofNode(i), own = aimed.ofSolid(j);
      for (const Vec3& corner : tree.solids()[j].triangle) {
        const Vec3 from = transformPoint(places[0], corner), to = transformPoint(places[1], corner);
        const Vec3 at = from + (to - from) * share;
        for (std::size_t k = 0; k < 3; ++k) {
          const double around = tree.solids()[j].radius_m;
          EXPECT_LE(own.low[k], dotOf(aim[k], at) - around);
          EXPECT_GE(own.high[k], dotOf(aim[k], at) + around);
          EXPECT_LE(extent.low[k], own.low[k]);
          EXPECT_GE(extent.high[k], own.high[k]);
        }
      }
    }
  }
}

TEST(AimedTree, AnAimIsAtRightAngles) {
  for (const Vec3& along : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{0.6, 0, -0.8}}) {
    const Aim aim = aimAlong(along);
    EXPECT_EQ(aim[0], along);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(lengthOf(aim[i]), 1, 1e-15);
      EXPECT_NEAR(dotOf(aim[i], aim[(i + 1) % 3]), 0, 1e-15);
    }
  }
}

TEST(AimedTree, ExtentsHoldWhatIsInThemAllAlongTheWay) {
  test::Random random(11);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const TriangleTree tree(random.solids(150));
    const std::array<Mat4, 2> places{random.placement(2), random.placement(2)};
    const Vec3 direction = random.point(1);
    const Aim aim = aimAlong(direction * (1 / lengthOf(direction)));
    AimedTree aimed;
    aimed.begin(tree);
    aimed.aim(aim, places, 0);
    // The inner ones: those of their children.
    for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
      const TriangleTree::Node& node = tree.nodes()[i];
      if (node.count > 0) continue;
      EXPECT_EQ(node.under, tree.nodes()[node.first].under + tree.nodes()[node.first + 1].under);
      if (node.under > 32) continue;
      const Extent outer = aimed.ofNode(i);
      for (const std::uint32_t child : {node.first, node.first + 1}) {
        const Extent inner = aimed.ofNode(child);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_LE(outer.low[k], inner.low[k]);
          EXPECT_GE(outer.high[k], inner.high[k]);
        }
      }
    }
    for (const double share : {0.0, 0.3, 1.0}) expectHolds(tree, aimed, aim, places, share);
  }
}

TEST(AimedTree, AnotherAimForgetsTheFirst) {
  const TriangleTree ball({{{Vec3(0), Vec3(0), Vec3(0)}, 0.25}});
  const std::array<Mat4, 1> here{translationMatrix({1, 2, 3})};
  AimedTree aimed;
  aimed.begin(ball);
  aimed.aim(aimAlong({1, 0, 0}), here, 0);
  EXPECT_NEAR(aimed.ofNode(0).low[0], 0.75, 1e-9);
  aimed.aim(aimAlong({0, 0, 1}), here, 0.5);
  EXPECT_NEAR(aimed.ofNode(0).low[0], 2.25, 1e-9);
  EXPECT_NEAR(aimed.ofSolid(0).high[0], 3.75, 1e-9);
}

}  // namespace
}  // namespace rocinante
