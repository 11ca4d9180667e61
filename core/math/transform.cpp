#include "core/math/transform.h"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

// Written out, because the order of the operations decides the last bits.
Quat product(const Quat& a, const Quat& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

}  // namespace

Quat quaternionFromRpy(const Vec3& rpy_rad) {
  const auto [sr, cr] = sineCosine(rpy_rad.x * 0.5);
  const auto [sp, cp] = sineCosine(rpy_rad.y * 0.5);
  const auto [sy, cy] = sineCosine(rpy_rad.z * 0.5);
  return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy};
}

Quat quaternionAbout(const Vec3& unit_axis, double angle_rad) {
  const auto [s, c] = sineCosine(angle_rad * 0.5);
  return {c, unit_axis.x * s, unit_axis.y * s, unit_axis.z * s};
}

std::optional<Quat> normalized(const Quat& q) {
  // Scaled first, so that squares neither overflow nor vanish.
  const double largest = std::max({std::fabs(q.w), std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
  const double w = q.w / largest, x = q.x / largest, y = q.y / largest, z = q.z / largest;
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  if (!std::isfinite(length)) return std::nullopt;
  return Quat{w / length, x / length, y / length, z / length};
}

double lengthOf(const Quat& q) {
  const double largest = std::max({std::fabs(q.w), std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return q.w + q.x + q.y + q.z;
  const double w = q.w / largest, x = q.x / largest, y = q.y / largest, z = q.z / largest;
  return largest * std::sqrt(w * w + x * x + y * y + z * z);
}

bool isUnitLength(const Quat& quaternion) {
  return std::abs(lengthOf(quaternion) - 1) <= kUnitLengthTolerance;
}

std::optional<Vec3> normalized(const Vec3& v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
  const Vec3 scaled{v.x / largest, v.y / largest, v.z / largest};
  const double length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
  if (!std::isfinite(length)) return std::nullopt;
  return Vec3{scaled.x / length, scaled.y / length, scaled.z / length};
}

Mat4 translationMatrix(const Vec3& offset) {
  Mat4 matrix{1.0};
  matrix[3] = Vec4(offset, 1.0);
  return matrix;
}

Mat4 rotationMatrix(const Quat& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  Mat4 matrix{1.0};
  matrix[0] = {1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (xz - wy), 0.0};
  matrix[1] = {2.0 * (xy - wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz + wx), 0.0};
  matrix[2] = {2.0 * (xz + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy), 0.0};
  return matrix;
}

Mat4 scaleMatrix(const Vec3& scale) {
  Mat4 matrix{1.0};
  matrix[0][0] = scale.x;
  matrix[1][1] = scale.y;
  matrix[2][2] = scale.z;
  return matrix;
}

Mat4 matrixOf(const Pose& pose) {
  Mat4 matrix = rotationMatrix(pose.orientation);
  matrix[3] = Vec4(pose.position, 1.0);
  return matrix;
}

Pose poseOf(const Mat4& m) {
  // The largest of the four squares is at least 1/4, so no divisor is small.
  const double trace = m[0][0] + m[1][1] + m[2][2];
  Quat q;
  if (trace >= m[0][0] && trace >= m[1][1] && trace >= m[2][2]) {
    q = {1.0 + trace, m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]};
  } else if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2]) {
    q = {m[1][2] - m[2][1], 1.0 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0],
         m[0][2] + m[2][0]};
  } else if (m[1][1] >= m[2][2]) {
    q = {m[2][0] - m[0][2], m[0][1] + m[1][0], 1.0 - m[0][0] + m[1][1] - m[2][2],
         m[1][2] + m[2][1]};
  } else {
    q = {m[0][1] - m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1],
         1.0 - m[0][0] - m[1][1] + m[2][2]};
  }
  return {positionOf(m), normalized(q).value_or(Quat{1, 0, 0, 0})};
}

Mat4 inverseOfRigid(const Mat4& m) {
  Mat4 inverse{1.0};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) inverse[row][column] = m[column][row];
    inverse[3][row] = -(m[row][0] * m[3][0] + m[row][1] * m[3][1] + m[row][2] * m[3][2]);
  }
  return inverse;
}

Pose composed(const Pose& first, const Pose& second) {
  return {transformPoint(matrixOf(first), second.position),
          product(first.orientation, second.orientation)};
}

Vec3 transformPoint(const Mat4& m, const Vec3& p) {
  return {m[0][0] * p.x + m[1][0] * p.y + m[2][0] * p.z + m[3][0],
          m[0][1] * p.x + m[1][1] * p.y + m[2][1] * p.z + m[3][1],
          m[0][2] * p.x + m[1][2] * p.y + m[2][2] * p.z + m[3][2]};
}

Vec3 transformDirection(const Mat4& m, const Vec3& d) {
  return {m[0][0] * d.x + m[1][0] * d.y + m[2][0] * d.z,
          m[0][1] * d.x + m[1][1] * d.y + m[2][1] * d.z,
          m[0][2] * d.x + m[1][2] * d.y + m[2][2] * d.z};
}

}  // namespace rocinante
