#include "viewer/ui/model/view_cube.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "core/math/transform.h"
#include "viewer/shown/turntable.h"

namespace rocinante {
namespace {

ViewAxes axesFrom(const Vec3& eye) {
  CameraView view;
  view.eye = eye;
  view.target = {0, 0, 0};
  const Camera camera(view, 1, 1, ClipDepth::zero_to_one, 1);
  return {camera.right(), camera.up(), camera.forward()};
}

std::vector<ViewSide> allSides() {
  std::vector<ViewSide> sides;
  for (int i = 0; i < 27; ++i) {
    const ViewSide side{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    if (side != ViewSide()) sides.push_back(side);
  }
  return sides;
}

Vec2 middleOf(const CubePatch& patch) { return (patch.corners[0] + patch.corners[2]) * 0.5; }

TEST(ViewCube, EverySideHasANameThatMeansIt) {
  std::set<std::string> names;
  for (const ViewSide& side : allSides()) {
    const std::string name = nameOf(side);
    EXPECT_TRUE(names.insert(name).second) << name;
    std::vector<std::string> words;
    for (std::size_t from = 0; from <= name.size();) {
      const std::size_t to = std::min(name.find(' ', from), name.size());
      words.push_back(name.substr(from, to - from));
      from = to + 1;
    }
    EXPECT_EQ(viewSideOf(words), side) << name;
    std::ranges::reverse(words);
    EXPECT_EQ(viewSideOf(words), side) << name;
    EXPECT_NEAR(lengthOf(directionFrom(side)), 1, 1e-12);
  }
  EXPECT_EQ(names.size(), 26U);
  EXPECT_TRUE(names.contains("bottom back left"));
}

TEST(ViewCube, OtherWordsAreNoSide) {
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{}, Words{"up"}, Words{"top", "bottom"}, Words{"left", "left"},
                             Words{"isometric", "top"}, Words{""}}) {
    EXPECT_FALSE(viewSideOf(words).has_value());
  }
  EXPECT_EQ(viewSideOf(Words{"isometric"}), (ViewSide{1, -1, 1}));
}

TEST(ViewCube, FromTheFrontOnlyTheFrontIsSeenAndTheLeftIsAtTheRight) {
  const ViewAxes axes = axesFrom({5, 0, 0});
  const auto faces = visibleFaces(axes);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].face, (ViewSide{1, 0, 0}));
  EXPECT_DOUBLE_EQ(faces[0].facing, 1);
  EXPECT_EQ(cubeSideAt(axes, {0, 0}), (ViewSide{1, 0, 0}));
  EXPECT_EQ(cubeSideAt(axes, {0.9, 0}), (ViewSide{1, 1, 0}));
  EXPECT_EQ(cubeSideAt(axes, {-0.9, 0}), (ViewSide{1, -1, 0}));
  EXPECT_EQ(cubeSideAt(axes, {0, -0.9}), (ViewSide{1, 0, 1}));
  EXPECT_EQ(cubeSideAt(axes, {0.9, 0.9}), (ViewSide{1, 1, -1}));
  EXPECT_FALSE(cubeSideAt(axes, {1.1, 0}).has_value());
  EXPECT_FALSE(cubeSideAt(axes, {0, -1.1}).has_value());
}

TEST(ViewCube, ALookFromASideShowsItInTheMiddle) {
  for (const ViewSide& side : allSides()) {
    Turntable camera;
    camera.lookFrom(directionFrom(side));
    const ViewAxes axes = axesFrom(camera.view().eye - camera.view().target);
    EXPECT_EQ(cubeSideAt(axes, {0.01, 0.01}), side) << nameOf(side);
  }
}

TEST(ViewCube, FromTheTopXIsToTheRight) {
  Turntable camera;
  camera.lookFrom({0, 0, 1});
  const ViewAxes axes = axesFrom(camera.view().eye - camera.view().target);
  EXPECT_NEAR(axes.right.x, 1, 1e-5);
  EXPECT_NEAR(axes.up.y, 1, 1e-5);
}

RC_GTEST_PROP(ViewCube, WhatIsDrawnOfASideIsWhereThatSideIsHit, ()) {
  const auto angle = [] { return *rc::gen::inRange(-31400, 31400) * 1e-4; };
  const double azimuth = angle(), height = angle() / 2.1;
  const ViewAxes axes = axesFrom({std::cos(azimuth) * std::cos(height) * 5,
                                  std::sin(azimuth) * std::cos(height) * 5, std::sin(height) * 5});
  const std::size_t faces = visibleFaces(axes).size();
  RC_ASSERT(faces >= 1U && faces <= 3U);
  for (const ViewSide& side : allSides()) {
    for (const CubePatch& patch : visiblePatches(axes, side)) {
      if (patch.facing < 0.01) continue;
      RC_ASSERT(cubeSideAt(axes, middleOf(patch)) == side);
    }
  }
}

RC_GTEST_PROP(ViewCube, WhatIsHitIsDrawnThere, ()) {
  const auto number = [](int most) { return *rc::gen::inRange(-most, most) * 1e-3; };
  const Vec3 eye(number(1000) + 1e-4, number(1000), number(900));
  const Vec2 at(number(1900), number(1900));
  const ViewAxes axes = axesFrom(eye * (5 / lengthOf(eye)));
  const auto side = cubeSideAt(axes, at);
  const auto inside = [&](const CubePatch& patch) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 edge = patch.corners[(i + 1) % 4] - patch.corners[i];
      const Vec2 from = at - patch.corners[i];
      // Clockwise where y points down: the inside is at the right of each edge.
      if (edge.x * from.y - edge.y * from.x < -1e-6) return false;
    }
    return true;
  };
  if (!side) {
    for (const CubePatch& face : visibleFaces(axes)) RC_ASSERT(face.facing < 1e-3 || !inside(face));
    return;
  }
  bool drawn = false;
  for (const CubePatch& patch : visiblePatches(axes, *side)) drawn = drawn || inside(patch);
  RC_ASSERT(drawn);
}

TEST(ViewCubePlace, IsTheTopRightThenBelowThenLeftOfWhatIsThere) {
  const PixelRectangle room{300, 0, 700, 600};
  EXPECT_EQ(placeViewCube(room, {}, 88, 10), (PixelRectangle{902, 10, 88, 88}));
  const std::vector<PixelRectangle> inset{{790, 12, 198, 150}};
  EXPECT_EQ(placeViewCube(room, inset, 88, 10), (PixelRectangle{902, 172, 88, 88}));
  const std::vector<PixelRectangle> tall{{790, 12, 198, 150}, {700, 170, 290, 400}};
  EXPECT_EQ(placeViewCube(room, tall, 88, 10), (PixelRectangle{692, 10, 88, 88}));
  const std::vector<PixelRectangle> everything{{300, 0, 700, 600}};
  EXPECT_FALSE(placeViewCube(room, everything, 88, 10).has_value());
}

TEST(ViewCubePlace, ThereIsNoneInASmallWindow) {
  EXPECT_FALSE(placeViewCube({0, 0, 290, 600}, {}, 88, 10).has_value());
  EXPECT_FALSE(placeViewCube({0, 0, 600, 290}, {}, 88, 10).has_value());
  EXPECT_FALSE(placeViewCube({0, 0, -5, 600}, {}, 88, 10).has_value());
}

}  // namespace
}  // namespace rocinante
