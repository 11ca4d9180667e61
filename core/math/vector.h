#pragma once

// GLM's types under our names. Where a result reaches a picture, only GLM's + - * / and sqrt may be
// used: its trigonometry is the C library's, which differs between CPUs (docs/decisions/003).
#ifndef GLM_FORCE_PURE
#define GLM_FORCE_PURE
#endif
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rocinante {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat4 = glm::dmat4;  ///< column major, column vectors: world = parent * local
using Quat = glm::dquat;  ///< glm's constructor takes (w, x, y, z); packets say x y z w

/// Position in metres and orientation as a unit quaternion.
struct Pose {
  Vec3 position{0, 0, 0};
  Quat orientation{1, 0, 0, 0};

  bool operator==(const Pose&) const = default;
};

/// Written out: GLM's own may be vectorised differently.
inline double dotOf(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 crossOf(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double lengthOf(const Vec3& a) { return std::sqrt(dotOf(a, a)); }

}  // namespace rocinante
