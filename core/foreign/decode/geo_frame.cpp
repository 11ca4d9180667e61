#include "core/foreign/decode/geo_frame.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante::decode {
namespace {

// WGS 84.
constexpr double kSemiMajorM = 6'378'137.0;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2 - kFlattening);

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

double along(const Vec3& axis, const Vec3& vector) {
  return axis.x * vector.x + axis.y * vector.y + axis.z * vector.z;
}

}  // namespace

GeoFrame::GeoFrame(const GeoPlace& origin) {
  const SineCosine latitude = sineCosine(origin.latitude_deg * kRadiansPerDegree);
  const SineCosine longitude = sineCosine(origin.longitude_deg * kRadiansPerDegree);
  const double normal_m =
      kSemiMajorM / std::sqrt(1 - kEccentricitySquared * latitude.sine * latitude.sine);
  const double from_axis_m = (normal_m + origin.height_m) * latitude.cosine;
  origin_m_ = Vec3(from_axis_m * longitude.cosine, from_axis_m * longitude.sine,
                   (normal_m * (1 - kEccentricitySquared) + origin.height_m) * latitude.sine);
  east_ = Vec3(-longitude.sine, longitude.cosine, 0);
  north_ =
      Vec3(-latitude.sine * longitude.cosine, -latitude.sine * longitude.sine, latitude.cosine);
  up_ = Vec3(latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine);
  Mat4 turn(1);
  for (int axis = 0; axis < 3; ++axis) {
    turn[axis] = Vec4(east_[axis], north_[axis], up_[axis], 0);
  }
  from_earth_ = poseOf(turn).orientation;
}

Vec3 GeoFrame::positionOf(const Vec3& earth_m) const {
  const Vec3 from_here = earth_m - origin_m_;
  return {along(east_, from_here), along(north_, from_here), along(up_, from_here)};
}

Quat GeoFrame::orientationOf(double psi_rad, double theta_rad, double phi_rad) const {
  const Quat body = quaternionFromRpy({phi_rad, theta_rad, psi_rad});
  // Half a turn about x: from y right, z down to y left, z up.
  const Quat left_and_up(0, 1, 0, 0);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return normalized(from_earth_ * body * left_and_up).value_or(Quat(kNone, kNone, kNone, kNone));
}

}  // namespace rocinante::decode
