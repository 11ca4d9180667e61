#include "viewer/ui/model/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr double kRing = 0.8;   ///< radius, in arrows
constexpr double kNear = 0.28;  ///< a square's edges, in arrows
constexpr double kFar = 0.5;
constexpr int kRingCorners = 48;

/// From a segment of the picture.
double distanceTo(const Vec2& at, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a, from = at - a;
  const double length = way.x * way.x + way.y * way.y;
  const double part = length > 0 ? (from.x * way.x + from.y * way.y) / length : 0;
  const Vec2 nearest = from - way * std::clamp(part, 0.0, 1.0);
  return std::sqrt(nearest.x * nearest.x + nearest.y * nearest.y);
}

/// A point is inside when all edges turn the same way about it.
bool isInside(const Vec2& at, const std::vector<Vec2>& corners) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 way = corners[(i + 1) % corners.size()] - corners[i];
    const Vec2 from = at - corners[i];
    const double side = way.x * from.y - way.y * from.x;
    (side > 0 ? left : right) = true;
  }
  return !corners.empty() && left != right;
}

/// Empty when a part is behind the eye.
std::vector<Vec2> shownOutline(const Gizmo& gizmo, const PicturePlaces& places,
                               const GizmoHandle& handle) {
  std::vector<Vec2> pixels;
  for (const Vec3& corner : outlineOf(gizmo, handle)) {
    const auto pixel = places.pixelOf(corner);
    if (!pixel) return {};
    pixels.push_back(*pixel);
  }
  return pixels;
}

double snapped(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

}  // namespace

std::optional<Vec2> PicturePlaces::pixelOf(const Vec3& world) const {
  const Vec4 clip = camera_.clipOf(world);
  if (!(clip.w > 1e-9)) return std::nullopt;
  return Vec2((clip.x / clip.w + 1) / 2 * camera_.width(),
              (1 - clip.y / clip.w) / 2 * camera_.height());
}

SightLine PicturePlaces::through(const Vec2& pixel) const {
  const double middle_x = (1 + camera_.center().x) / 2 * camera_.width();
  const double middle_y = (1 - camera_.center().y) / 2 * camera_.height();
  // At a depth of one metre.
  const double metres = camera_.metersPerPixel(1);
  const Vec3 beside = camera_.right() * ((pixel.x - middle_x) * metres * camera_.pixelAspect()) -
                      camera_.up() * ((pixel.y - middle_y) * metres);
  if (camera_.orthographic()) return {camera_.eye() + beside, camera_.forward()};
  return {camera_.eye(), camera_.forward() + beside};
}

std::vector<Vec3> outlineOf(const Gizmo& gizmo, const GizmoHandle& handle) {
  const Vec3& axis = gizmo.axes[handle.axis];
  const Vec3 across = gizmo.axes[(handle.axis + 1) % 3] * gizmo.size_m;
  const Vec3 along = gizmo.axes[(handle.axis + 2) % 3] * gizmo.size_m;
  switch (handle.kind) {
    case GizmoHandle::Kind::arrow:
      return {gizmo.origin, gizmo.origin + axis * gizmo.size_m};
    case GizmoHandle::Kind::square:
      return {gizmo.origin + across * kNear + along * kNear,
              gizmo.origin + across * kFar + along * kNear,
              gizmo.origin + across * kFar + along * kFar,
              gizmo.origin + across * kNear + along * kFar};
    case GizmoHandle::Kind::ring:
      break;
  }
  std::vector<Vec3> ring;
  for (int i = 0; i < kRingCorners; ++i) {
    const SineCosine turn = sineCosine(2 * kPi * i / kRingCorners);
    ring.push_back(gizmo.origin + (across * turn.cosine + along * turn.sine) * kRing);
  }
  return ring;
}

std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const PicturePlaces& places,
                                    const Vec2& pixel, double reach_px) {
  using Kind = GizmoHandle::Kind;
  for (int axis = 0; axis < 3; ++axis) {
    const GizmoHandle square{Kind::square, axis};
    if (isInside(pixel, shownOutline(gizmo, places, square))) return square;
  }
  std::optional<GizmoHandle> nearest;
  double reach = reach_px;
  for (const Kind kind : {Kind::arrow, Kind::ring}) {
    for (int axis = 0; axis < 3; ++axis) {
      const GizmoHandle handle{kind, axis};
      const std::vector<Vec2> corners = shownOutline(gizmo, places, handle);
      const std::size_t edges = kind == Kind::arrow && !corners.empty() ? 1 : corners.size();
      for (std::size_t i = 0; i < edges; ++i) {
        const double distance = distanceTo(pixel, corners[i], corners[(i + 1) % corners.size()]);
        if (distance >= reach) continue;
        reach = distance;
        nearest = handle;
      }
    }
  }
  return nearest;
}

std::optional<double> placeOnAxis(const SightLine& line, const Vec3& origin, const Vec3& axis) {
  const double length = lengthOf(line.way);
  if (!(length > 0)) return std::nullopt;
  const Vec3 way = line.way / length;
  const double together = dotOf(way, axis);
  const double apart = 1 - together * together;
  // Within two degrees of the axis a pixel would be metres.
  if (apart < 1e-3) return std::nullopt;
  const Vec3 between = line.from - origin;
  return (dotOf(between, axis) - dotOf(between, way) * together) / apart;
}

std::optional<Vec3> placeOnPlane(const SightLine& line, const Vec3& origin, const Vec3& normal) {
  const double length = lengthOf(line.way);
  if (!(length > 0)) return std::nullopt;
  const double falls = dotOf(line.way, normal) / length;
  if (std::abs(falls) < 0.02) return std::nullopt;
  const double distance = dotOf(origin - line.from, normal) / falls;
  if (distance < 0) return std::nullopt;
  return line.from + line.way * (distance / length);
}

std::optional<GizmoChange> changeOf(const Gizmo& gizmo, const GizmoHandle& handle,
                                    const SightLine& from, const SightLine& to) {
  const Vec3& axis = gizmo.axes[handle.axis];
  GizmoChange change;
  if (handle.kind == GizmoHandle::Kind::arrow) {
    const auto before = placeOnAxis(from, gizmo.origin, axis);
    const auto now = placeOnAxis(to, gizmo.origin, axis);
    if (!before || !now) return std::nullopt;
    change.moved[handle.axis] = *now - *before;
    return change;
  }
  const auto before = placeOnPlane(from, gizmo.origin, axis);
  const auto now = placeOnPlane(to, gizmo.origin, axis);
  if (!before || !now) return std::nullopt;
  const int first = (handle.axis + 1) % 3, second = (handle.axis + 2) % 3;
  const auto along = [&](const Vec3& place, int of) {
    return dotOf(place - gizmo.origin, gizmo.axes[of]);
  };
  if (handle.kind == GizmoHandle::Kind::square) {
    for (const int of : {first, second}) change.moved[of] = along(*now, of) - along(*before, of);
    return change;
  }
  const auto angle = [&](const Vec3& place) {
    return arcTangent2(along(place, second), along(place, first));
  };
  change.turned = angle(*now) - angle(*before);
  // The shorter way about.
  if (change.turned > kPi) change.turned -= 2 * kPi;
  if (change.turned < -kPi) change.turned += 2 * kPi;
  return change;
}

Pose changedPose(const Pose& start, const GizmoHandle& handle, const GizmoChange& change,
                 const GizmoSteps& steps) {
  Pose pose = start;
  if (handle.kind == GizmoHandle::Kind::ring) {
    Vec3 axis(0, 0, 0);
    axis[handle.axis] = 1;
    const double turned = snapped(change.turned, steps.radians);
    if (turned == 0) return start;
    pose.orientation = quaternionAbout(axis, turned) * start.orientation;
    return pose;
  }
  for (int i = 0; i < 3; ++i) {
    const bool is_moved = (handle.kind == GizmoHandle::Kind::arrow) == (handle.axis == i);
    if (is_moved) pose.position[i] = snapped(start.position[i] + change.moved[i], steps.metres);
  }
  return pose;
}

}  // namespace rocinante
