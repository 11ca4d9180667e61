#include "viewer/view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

bool finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

double halfHeightOf(double fov_deg) {
  const double bounded = std::isfinite(fov_deg) ? std::clamp(fov_deg, 0.01, 179.0) : 45.0;
  return tangent(radiansOf(bounded) / 2);
}

/// Distance of the near plane as a share of the target's: with float depth from 1 to 0 it costs no
/// precision.
constexpr double kNearPart = 1e-3;

}  // namespace

Camera::Camera(const CameraView& view, int width, int height, ClipDepth depth, double reach_m)
    : width_(std::max(width, 1)),
      height_(std::max(height, 1)),
      eye_(finite(view.eye) ? view.eye : Vec3(0, 0, 0)),
      orthographic_(view.ortho_height_m && *view.ortho_height_m > 0 &&
                    std::isfinite(*view.ortho_height_m)),
      reach_m_(reach_m > 0 && std::isfinite(reach_m) ? reach_m : 1.0) {
  const Vec3 toward = finite(view.target) ? view.target - eye_ : Vec3(0, 0, 0);
  const double distance = lengthOf(toward);
  forward_ = distance > 1e-12 ? toward / distance : Vec3(1, 0, 0);
  right_ = finite(view.up) ? crossOf(forward_, view.up) : Vec3(0, 0, 0);
  if (lengthOf(right_) < 1e-9) {
    // Looking along up: use x as the picture's top, or y when looking along x too.
    const Vec3 other = std::abs(forward_.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    right_ = crossOf(forward_, other);
  }
  right_ /= lengthOf(right_);
  up_ = crossOf(right_, forward_);

  const double aspect = static_cast<double>(width_) / height_;
  half_height_ = orthographic_ ? *view.ortho_height_m / 2 : halfHeightOf(view.fov_deg);
  half_width_ = half_height_ * aspect;
  if (view.intrinsics && !orthographic_) {
    const CameraIntrinsics& lens = *view.intrinsics;
    const LensFit fit = fitOf(lens, width_, height_);
    half_width_ = width_ / (2 * fit.scale * lens.fx);
    half_height_ = height_ / (2 * fit.scale * lens.fy);
    pixel_aspect_ = lens.fy / lens.fx;
    // Whole numbers of OpenCV are the centres of pixels.
    center_ = {2 * (fit.left + fit.scale * (lens.cx + 0.5)) / width_ - 1,
               1 - 2 * (fit.top + fit.scale * (lens.cy + 0.5)) / height_};
  }
  near_m_ = std::clamp(distance * kNearPart, 1e-5, 1.0);

  // Rows of the matrix from world axes, relative to the eye, to clip space.
  Vec4 x(right_ / half_width_, 0);
  Vec4 y(up_ / half_height_, 0);
  Vec4 w(forward_, 0);
  Vec4 z(0, 0, 0, near_m_);
  if (orthographic_) {
    w = Vec4(0, 0, 0, 1);
    z = Vec4(-forward_ / (2 * reach_m_), 0.5);
  }
  if (center_ != Vec2(0, 0)) {
    x += w * center_.x;
    y += w * center_.y;
  }
  if (depth == ClipDepth::minus_one_to_one) z = z * 2.0 - w;
  for (int column = 0; column < 4; ++column) {
    clip_from_relative_[column] = Vec4(x[column], y[column], z[column], w[column]);
  }
}

Mat4 Camera::relative(const Mat4& world) const {
  Mat4 moved = world;
  moved[3] = Vec4(Vec3(world[3]) - eye_, 1.0);
  return moved;
}

Vec4 Camera::clipOf(const Vec3& world) const {
  const Vec3 p = world - eye_;
  const Mat4& m = clip_from_relative_;
  Vec4 clip;
  for (int row = 0; row < 4; ++row) {
    clip[row] = m[0][row] * p.x + m[1][row] * p.y + m[2][row] * p.z + m[3][row];
  }
  return clip;
}

double Camera::depthOf(const Vec3& world) const { return dotOf(world - eye_, forward_); }

double Camera::depthAt(double stored) const {
  if (!(stored > 0)) return std::numeric_limits<double>::infinity();
  return orthographic_ ? (0.5 - stored) * 2 * reach_m_ : near_m_ / stored;
}

double Camera::metersPerPixel(double depth_m) const {
  const double half = orthographic_ ? half_height_ : half_height_ * std::max(depth_m, near_m_);
  return 2 * half / height_;
}

bool Camera::sees(const Vec3& center, double radius) const {
  const Vec3 offset = center - eye_;
  const double x = dotOf(offset, right_);
  const double y = dotOf(offset, up_);
  if (orthographic_) {
    return std::abs(x) <= half_width_ + radius && std::abs(y) <= half_height_ + radius;
  }
  const double z = dotOf(offset, forward_);
  if (z < -radius) return false;
  // Distance from a side plane through the eye, whose normal is (1, -half) normalized.
  const auto inside = [&](double across, double half) {
    return across - half * z <= radius * std::sqrt(1 + half * half);
  };
  return inside(x, half_width_ * (1 - center_.x)) && inside(-x, half_width_ * (1 + center_.x)) &&
         inside(y, half_height_ * (1 - center_.y)) && inside(-y, half_height_ * (1 + center_.y));
}

CameraView mapView(const std::vector<Vec3>& points, int width, int height) {
  constexpr double kMapMargin = 1.08;
  Vec3 least(-5, -5, 0);
  Vec3 most(5, 5, 0);
  if (!points.empty()) least = most = points.front();
  for (const Vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], point[axis]);
      most[axis] = std::max(most[axis], point[axis]);
    }
  }
  const Vec3 middle = (least + most) * 0.5;
  const double aspect = static_cast<double>(std::max(width, 1)) / std::max(height, 1);
  const double metres = std::max(most.y - least.y, (most.x - least.x) / aspect) * kMapMargin;
  CameraView view;
  view.eye = {middle.x, middle.y, most.z + 1};
  view.target = {middle.x, middle.y, least.z};
  view.up = {0, 1, 0};
  view.ortho_height_m = metres > 0 && std::isfinite(metres) ? metres : 1.0;
  return view;
}

CameraView fittedView(const std::vector<Vec3>& points, int width, int height) {
  constexpr double kFovDeg = 35;
  constexpr double kMargin = 1.08;
  CameraView view;
  view.fov_deg = kFovDeg;
  if (points.empty()) return view;

  // From front right and above: x forward, y left.
  const Vec3 from(0.62, -0.66, 0.42);
  const Vec3 forward = -from / lengthOf(from);
  Vec3 right = crossOf(forward, Vec3(0, 0, 1));
  right /= lengthOf(right);
  const Vec3 up = crossOf(right, forward);
  const double half_height = halfHeightOf(kFovDeg) / kMargin;
  const double half_width = half_height * width / std::max(height, 1);

  // Each side of the picture is a plane with all points inside: p is inside the right one when x(p)
  // - x(eye) <= half_width * (z(p) - z(eye)). The eye is the intersection of two opposite planes
  // through the outermost points; the farther back of both pairs decides.
  const double lowest = -1e300;
  double right_most = lowest, left_most = lowest, top_most = lowest, bottom_most = lowest;
  double nearest = 1e300;
  for (const Vec3& point : points) {
    const double x = dotOf(point, right);
    const double y = dotOf(point, up);
    const double z = dotOf(point, forward);
    right_most = std::max(right_most, x - half_width * z);
    left_most = std::max(left_most, -x - half_width * z);
    top_most = std::max(top_most, y - half_height * z);
    bottom_most = std::max(bottom_most, -y - half_height * z);
    nearest = std::min(nearest, z);
  }
  const double eye_x = (right_most - left_most) / 2;
  const double eye_y = (top_most - bottom_most) / 2;
  double eye_z = std::min(-(right_most + left_most) / (2 * half_width),
                          -(top_most + bottom_most) / (2 * half_height));
  // A single point has no size: use a distance of one metre.
  if (nearest - eye_z < 1e-6) eye_z = nearest - 1.0;

  double farthest = nearest;
  for (const Vec3& point : points) farthest = std::max(farthest, dotOf(point, forward));
  view.eye = right * eye_x + up * eye_y + forward * eye_z;
  view.target = view.eye + forward * ((nearest + farthest) / 2 - eye_z);
  return view;
}

CameraView carriedView(const CameraView& view, const Mat4& carrier) {
  CameraView carried = view;
  carried.eye = transformPoint(carrier, view.eye);
  carried.target = transformPoint(carrier, view.target);
  carried.up = transformDirection(carrier, view.up);
  return carried;
}

}  // namespace rocinante
