#pragma once

#include <optional>

#include "core/math/vector.h"

namespace rocinante {

/// Rigid motions in double from + - * / sqrt and our own trigonometry: the same bits on every CPU.
/// Metres and radians; right-handed; x forward, y left, z up.

/// Unit quaternion of fixed-axis roll, pitch, yaw as URDF has them: Rz(yaw) * Ry(pitch) * Rx(roll).
Quat quaternionFromRpy(const Vec3& rpy_rad);
/// Rotation by `angle_rad` about a unit axis.
Quat quaternionAbout(const Vec3& unit_axis, double angle_rad);
/// Scaled to unit length; empty when it is zero or not finite.
std::optional<Quat> normalized(const Quat& quaternion);
std::optional<Vec3> normalized(const Vec3& vector);
/// How far from 1 the length of a unit quaternion may be where it comes in. What is further off is
/// normalised and used, and named: its sender probably computes it wrongly.
inline constexpr double kUnitLengthTolerance = 1e-3;
/// Without overflow; not finite when the quaternion is not, or its length is not.
double lengthOf(const Quat& quaternion);
bool isUnitLength(const Quat& quaternion);

Mat4 translationMatrix(const Vec3& offset);
Mat4 rotationMatrix(const Quat& unit_rotation);
Mat4 scaleMatrix(const Vec3& scale);
Mat4 matrixOf(const Pose& pose);

/// The pose of a rotation-and-translation matrix.
Pose poseOf(const Mat4& rigid);
/// Inverse of a rotation-and-translation matrix.
Mat4 inverseOfRigid(const Mat4& rigid);
/// `second` expressed in `first`: matrixOf(first) * matrixOf(second).
Pose composed(const Pose& first, const Pose& second);

Vec3 transformPoint(const Mat4& matrix, const Vec3& point);
Vec3 transformDirection(const Mat4& matrix, const Vec3& direction);
inline Vec3 positionOf(const Mat4& matrix) { return Vec3(matrix[3]); }

}  // namespace rocinante
