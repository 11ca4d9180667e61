#include "core/check/drift/pose_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

// Exporters print about six digits.
constexpr double kSameRatio = 1e-9;
constexpr double kSameLength_m = 1e-7;
constexpr double kSameAngle_deg = 1e-4;

std::string lengthText(double length_m) {
  return length_m < 1 ? fmt::format("{:.3g} mm", length_m * 1000)
                      : fmt::format("{:.4g} m", length_m);
}

}  // namespace

bool isSameNumber(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  return std::abs(a - b) <= kSameLength_m + kSameRatio * std::max(std::abs(a), std::abs(b));
}

double angleDrift_deg(const Vec3& recorded, const Vec3& given) {
  // By the chord: an arc cosine loses half its digits where vectors are nearly the same.
  const double chord = lengthOf(given - recorded);
  const double angle_deg = degreesOf(2 * arcSine(std::min(1.0, chord / 2)));
  return angle_deg < kSameAngle_deg ? 0 : angle_deg;
}

std::string poseDrift(const Pose& recorded, const Pose& given) {
  const double moved_m = lengthOf(given.position - recorded.position);
  const Quat& a = recorded.orientation;
  const Quat& b = given.orientation;
  const double same = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  // A quaternion and its negative are the same rotation.
  const double sign = same < 0 ? -1 : 1;
  const double chord =
      std::sqrt((a.w - sign * b.w) * (a.w - sign * b.w) + (a.x - sign * b.x) * (a.x - sign * b.x) +
                (a.y - sign * b.y) * (a.y - sign * b.y) + (a.z - sign * b.z) * (a.z - sign * b.z));
  const double turned_deg = degreesOf(4 * arcSine(std::min(1.0, chord / 2)));
  const double rounding_m =
      kSameLength_m + kSameRatio * std::max(lengthOf(recorded.position), lengthOf(given.position));
  const bool moved = moved_m > rounding_m, turned = turned_deg > kSameAngle_deg;
  if (!moved && !turned) return "";
  std::string text = "has ";
  if (moved) text += "moved by " + lengthText(moved_m);
  if (moved && turned) text += " and ";
  if (turned) text += fmt::format("turned by {:.4g}°", turned_deg);
  return text;
}

}  // namespace rocinante
