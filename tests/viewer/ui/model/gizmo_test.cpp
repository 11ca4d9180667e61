#include "viewer/ui/model/gizmo.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

using HandleKind = GizmoHandle::Kind;

CameraView viewFrom(const Vec3& eye, std::optional<double> ortho = {}) {
  CameraView view;
  view.eye = eye;
  view.target = {0, 0, 0};
  view.ortho_height_m = ortho;
  return view;
}

double number(int most) { return *rc::gen::inRange(-most, most) * 1e-3; }

void expectNear(const Vec3& a, const Vec3& b, double most = 1e-9) {
  EXPECT_NEAR(lengthOf(a - b), 0, most) << a.x << ' ' << a.y << ' ' << a.z;
}

RC_GTEST_PROP(PicturePlaces, AReturnedLineOfSightGoesThroughWhatIsThere, ()) {
  const bool ortho = *rc::gen::arbitrary<bool>();
  const Vec3 eye(number(9000) + 0.0005, number(9000), number(9000) + 0.5);
  const PicturePlaces places(viewFrom(eye, ortho ? std::optional(4.0) : std::nullopt), 800, 600);
  const Vec3 point(number(900), number(900), number(900));
  const auto pixel = places.pixelOf(point);
  RC_PRE(pixel.has_value());
  RC_PRE(ortho || places.camera().depthOf(point) > 0.1);
  const SightLine line = places.through(*pixel);
  const Vec3 way = line.way / lengthOf(line.way);
  const Vec3 from = point - line.from;
  RC_ASSERT(lengthOf(from - way * dotOf(from, way)) < 1e-6);
}

TEST(PicturePlaces, NothingIsBehindTheEye) {
  const PicturePlaces places(viewFrom({5, 0, 0}), 800, 600);
  EXPECT_FALSE(places.pixelOf({6, 0, 0}).has_value());
  EXPECT_EQ(places.pixelOf({0, 0, 0}), Vec2(400, 300));
}

RC_GTEST_PROP(Gizmo, TheNearestPlaceOnAnAxisIsWhereTheConnectionIsSquareToBoth, ()) {
  const Vec3 aim(number(1000), number(1000), number(1000) + 1.5);
  const Vec3 axis = aim / lengthOf(aim);
  const Vec3 origin(number(2000), number(2000), number(2000));
  const SightLine line{{number(9000), number(9000), number(9000)},
                       {number(1000) + 1.2, number(1000), number(300)}};
  const auto place = placeOnAxis(line, origin, axis);
  if (!place) {
    RC_ASSERT(std::abs(dotOf(line.way, axis)) / lengthOf(line.way) > 0.99);
    return;
  }
  const Vec3 on_axis = origin + axis * *place;
  const Vec3 way = line.way / lengthOf(line.way);
  const Vec3 on_line = line.from + way * dotOf(on_axis - line.from, way);
  RC_ASSERT(std::abs(dotOf(on_line - on_axis, axis)) < 1e-6);
}

RC_GTEST_PROP(Gizmo, APlaceOnAPlaneIsOnBoth, ()) {
  const Vec3 origin(number(2000), number(2000), number(2000));
  const SightLine line{{number(9000), number(9000), 5}, {number(900), number(900), -1}};
  const Vec3 normal(0, 0.6, 0.8);
  const auto place = placeOnPlane(line, origin, normal);
  if (!place) return;
  RC_ASSERT(std::abs(dotOf(*place - origin, normal)) < 1e-6);
  const Vec3 way = line.way / lengthOf(line.way);
  const Vec3 from = *place - line.from;
  RC_ASSERT(dotOf(from, way) >= 0);
  RC_ASSERT(lengthOf(from - way * dotOf(from, way)) < 1e-6);
}

TEST(Gizmo, AlongALineOfSightThereIsNoPlace) {
  EXPECT_FALSE(placeOnAxis({{5, 0, 0}, {-1, 0, 0}}, {0, 0, 0}, {1, 0, 0}).has_value());
  EXPECT_FALSE(placeOnPlane({{5, 0, 0}, {-1, 0, 0}}, {0, 0, 0}, {0, 0, 1}).has_value());
  EXPECT_FALSE(placeOnPlane({{5, 0, 1}, {-1, 0, 1}}, {0, 0, 0}, {0, 0, 1}).has_value());
  EXPECT_FALSE(placeOnAxis({{5, 0, 0}, {0, 0, 0}}, {0, 0, 0}, {1, 0, 0}).has_value());
}

RC_GTEST_PROP(Gizmo, ADragAlongAnAxisMovesAsFarAsTheMouseDoesOnIt, ()) {
  const Vec3 eye(4 + number(2000), -5 + number(2000), 3 + number(2000));
  const PicturePlaces places(viewFrom(eye), 800, 600);
  const int axis = *rc::gen::inRange(0, 3);
  const Gizmo gizmo{{number(500), number(500), number(500)}};
  const double from = number(400), to = number(400);
  const auto pixel = [&](double at) {
    return *places.pixelOf(gizmo.origin + gizmo.axes[axis] * at);
  };
  const auto change = changeOf(gizmo, {HandleKind::arrow, axis}, places.through(pixel(from)),
                               places.through(pixel(to)));
  RC_ASSERT(change.has_value());
  Vec3 expected(0, 0, 0);
  expected[axis] = to - from;
  RC_ASSERT(lengthOf(change->moved - expected) < 1e-6);
}

TEST(Gizmo, ASquareMovesInItsPlaneAndARingTurns) {
  const Gizmo gizmo{};
  const PicturePlaces places(viewFrom({3, -4, 5}), 800, 600);
  const auto line = [&](const Vec3& at) { return places.through(*places.pixelOf(at)); };
  const auto square =
      changeOf(gizmo, {HandleKind::square, 2}, line({0.4, 0.4, 0}), line({0.7, 0.1, 0}));
  ASSERT_TRUE(square.has_value());
  expectNear(square->moved, {0.3, -0.3, 0}, 1e-9);
  const auto ring = changeOf(gizmo, {HandleKind::ring, 2}, line({0.8, 0, 0}), line({0, 0.8, 0}));
  ASSERT_TRUE(ring.has_value());
  EXPECT_NEAR(ring->turned, kPi / 2, 1e-9);
  // Across the half turn, the short way.
  const auto back =
      changeOf(gizmo, {HandleKind::ring, 2}, line({-0.8, 0.1, 0}), line({-0.8, -0.1, 0}));
  EXPECT_GT(back->turned, 0);
  EXPECT_LT(back->turned, 0.3);
}

TEST(Gizmo, HandlesAreHitWhereTheyAreDrawn) {
  const Gizmo gizmo{};
  const PicturePlaces places(viewFrom({3, -4, 5}), 800, 600);
  const auto hit = [&](const Vec3& at) { return handleAt(gizmo, places, *places.pixelOf(at), 6); };
  EXPECT_EQ(hit({0.95, 0, 0}), (GizmoHandle{HandleKind::arrow, 0}));
  EXPECT_EQ(hit({0, 0, 0.95}), (GizmoHandle{HandleKind::arrow, 2}));
  EXPECT_EQ(hit({0.4, 0.4, 0}), (GizmoHandle{HandleKind::square, 2}));
  EXPECT_EQ(hit({0.8 * std::sqrt(0.5), -0.8 * std::sqrt(0.5), 0}),
            (GizmoHandle{HandleKind::ring, 2}));
  EXPECT_FALSE(handleAt(gizmo, places, {5, 5}, 6).has_value());
  for (const HandleKind kind : {HandleKind::arrow, HandleKind::square, HandleKind::ring}) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(outlineOf(gizmo, {kind, axis}).size(), 2U);
    }
  }
}

TEST(Gizmo, WhatMovesComesToStepsOfItsSpaceAndWhatTurnsTurnsBySteps) {
  const Pose start{{0.123, 2, 0}, {1, 0, 0, 0}};
  const GizmoSteps steps{0.1, radiansOf(15)};
  expectNear(changedPose(start, {HandleKind::arrow, 0}, {{0.31, 9, 9}, 0}, steps).position,
             {0.4, 2, 0});
  expectNear(changedPose(start, {HandleKind::square, 2}, {{0.31, 0.07, 9}, 0}, steps).position,
             {0.4, 2.1, 0});
  expectNear(changedPose(start, {HandleKind::arrow, 0}, {{0.31, 0, 0}, 0}, {0, 0}).position,
             {0.433, 2, 0});
  const Pose turned = changedPose(start, {HandleKind::ring, 2}, {{0, 0, 0}, radiansOf(40)}, steps);
  EXPECT_NEAR(std::abs(glm::dot(turned.orientation, quaternionAbout({0, 0, 1}, radiansOf(45)))), 1,
              1e-12);
  EXPECT_EQ(changedPose(start, {HandleKind::ring, 2}, {{0, 0, 0}, radiansOf(7)}, steps), start);
}

}  // namespace
}  // namespace rocinante
