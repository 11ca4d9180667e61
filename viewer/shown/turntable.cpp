#include "viewer/shown/turntable.h"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

// Just below the pole, where "up" is undefined.
constexpr double kMaxElevation = kPi / 2 - 0.001;
constexpr double kMinDistance = 0.01;
constexpr double kMaxDistance = 1e6;

double heightAt(double distance_m, double fov_deg) {
  return 2 * distance_m * tangent(radiansOf(fov_deg) / 2);
}

}  // namespace

Turntable::Turntable(const CameraView& view)
    : target_(view.target), fov_deg_(view.fov_deg), ortho_height_m_(view.ortho_height_m) {
  const Vec3 offset = view.eye - view.target;
  const double length = std::sqrt(glm::dot(offset, offset));
  if (!(length > 0) || !std::isfinite(length)) return;
  distance_m_ = std::clamp(length, kMinDistance, kMaxDistance);
  const double level = std::sqrt(offset.x * offset.x + offset.y * offset.y);
  elevation_rad_ = std::clamp(arcTangent2(offset.z, level), -kMaxElevation, kMaxElevation);
  if (level > 1e-9 * length) {
    azimuth_rad_ = arcTangent2(offset.y, offset.x);
  } else if (glm::dot(view.up, view.up) > 0) {
    // From straight above: the picture's up direction points behind the target.
    azimuth_rad_ = arcTangent2(-view.up.y, -view.up.x);
  }
}

Vec3 Turntable::direction() const {
  const SineCosine azimuth = sineCosine(azimuth_rad_);
  const SineCosine elevation = sineCosine(elevation_rad_);
  return {azimuth.cosine * elevation.cosine, azimuth.sine * elevation.cosine, elevation.sine};
}

CameraView Turntable::view() const {
  CameraView view;
  view.eye = target_ + direction() * distance_m_;
  view.target = target_;
  view.fov_deg = fov_deg_;
  view.ortho_height_m = ortho_height_m_;
  return view;
}

double Turntable::heightM() const {
  return ortho_height_m_.value_or(heightAt(distance_m_, fov_deg_));
}

void Turntable::orbit(double dx_px, double dy_px, int height_px) {
  const double radians_per_px = kPi / std::max(1, height_px);
  azimuth_rad_ -= dx_px * radians_per_px;
  if (azimuth_rad_ > kPi) azimuth_rad_ -= 2 * kPi;
  if (azimuth_rad_ < -kPi) azimuth_rad_ += 2 * kPi;
  elevation_rad_ =
      std::clamp(elevation_rad_ + dy_px * radians_per_px, -kMaxElevation, kMaxElevation);
}

void Turntable::pan(double dx_px, double dy_px, int height_px) {
  const Vec3 forward = -direction();
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 0, 1)));
  const Vec3 up = glm::cross(right, forward);
  const double meters_per_px = heightM() / std::max(1, height_px);
  target_ += right * (-dx_px * meters_per_px) + up * (dy_px * meters_per_px);
}

void Turntable::zoom(double steps) {
  // Whole steps one by one and the rest in proportion: the last bits of pow() differ by CPU.
  double factor = 1;
  double left = std::clamp(steps, -50.0, 50.0);
  for (; left >= 1; left -= 1) factor *= 0.9;
  for (; left <= -1; left += 1) factor /= 0.9;
  factor *= left >= 0 ? 1 - 0.1 * left : 1 / (1 + 0.1 * left);
  if (ortho_height_m_) {
    ortho_height_m_ = std::clamp(*ortho_height_m_ * factor, kMinDistance, kMaxDistance);
  } else {
    distance_m_ = std::clamp(distance_m_ * factor, kMinDistance, kMaxDistance);
  }
}

void Turntable::zoomAt(double steps, double right_px, double down_px, int height_px) {
  const double before_m = heightM();
  zoom(steps);
  const double kept = heightM() / before_m;
  // Pan back the movement of the point.
  const double grown = 1 / kept - 1;
  pan(-right_px * grown, -down_px * grown, height_px);
}

void Turntable::fly(double right_m, double forward_m, double up_m) {
  const Vec3 forward = -direction();
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 0, 1)));
  if (ortho_height_m_) {
    target_ += right * right_m + glm::cross(right, forward) * forward_m;
    ortho_height_m_ = std::clamp(*ortho_height_m_ + up_m, kMinDistance, kMaxDistance);
    return;
  }
  target_ += right * right_m + forward * forward_m + Vec3(0, 0, up_m);
}

void Turntable::lookAround(double dx_px, double dy_px, int height_px) {
  const Vec3 eye = target_ + direction() * distance_m_;
  orbit(dx_px / 2, dy_px / 2, height_px);
  target_ = eye - direction() * distance_m_;
}

void Turntable::lookFrom(const Vec3& direction) {
  const double level = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  const bool is_level = level > 1e-9 * std::abs(direction.z);
  azimuth_rad_ = is_level ? arcTangent2(direction.y, direction.x) : -kPi / 2;
  elevation_rad_ = std::clamp(arcTangent2(direction.z, level), -kMaxElevation, kMaxElevation);
}

void Turntable::fit(const std::vector<Vec3>& points, int width_px, int height_px) {
  if (points.empty()) return;
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const double radius = std::max(0.5 * std::sqrt(glm::dot(high - low, high - low)), kMinDistance);
  target_ = (low + high) * 0.5;
  const double aspect = static_cast<double>(std::max(1, width_px)) / std::max(1, height_px);
  const double narrow = std::min(1.0, aspect);
  if (ortho_height_m_) {
    ortho_height_m_ = 2.1 * radius / narrow;
    distance_m_ = std::clamp(2 * radius, kMinDistance, kMaxDistance);
    return;
  }
  // The bounding sphere touches the sides of the view's cone.
  const double half_rad = arcTangent(tangent(radiansOf(fov_deg_) / 2) * narrow);
  distance_m_ = std::clamp(1.02 * radius / sine(half_rad), kMinDistance, kMaxDistance);
}

}  // namespace rocinante
