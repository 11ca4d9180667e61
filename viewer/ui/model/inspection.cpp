#include "viewer/ui/model/inspection.h"

#include <algorithm>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "core/packet/packet_text.h"

namespace rocinante {

std::string Selection::path() const {
  if (device.empty()) return {};
  return link.empty() ? encodeName(device) : encodeName(device) + "/" + encodeName(link);
}

std::optional<Pose> poseIn(const PosedScene& scene, const Selection& what, const Selection& in) {
  const auto place = scene.find(what.device, what.link);
  if (!place) return std::nullopt;
  if (in.device.empty()) return poseOf(*place);
  const auto space = scene.find(in.device, in.link);
  if (!space) return std::nullopt;
  return poseOf(inverseOfRigid(*space) * *place);
}

Vec3 rpyOf(const Quat& rotation) {
  const Mat4 m = rotationMatrix(rotation);
  // Columns first: m[0] is where x goes.
  const double pitch = arcSine(std::clamp(-m[0].z, -1.0, 1.0));
  constexpr double kLevel = 1e-12;
  if (m[0].x * m[0].x + m[0].y * m[0].y < kLevel) {
    return {0, pitch, arcTangent2(-m[1].x, m[1].y)};
  }
  return {arcTangent2(m[1].z, m[2].z), pitch, arcTangent2(m[0].y, m[0].x)};
}

std::optional<MeasureStyle> DistancePicking::add(const PosedScene& scene, const Selection& link,
                                                 const Vec3& point) {
  const auto space = scene.find(link.device, link.link);
  if (!active_ || !space) return std::nullopt;
  MeasurePoint here{link.path(), transformPoint(inverseOfRigid(*space), point)};
  if (!first_) {
    first_ = std::move(here);
    return std::nullopt;
  }
  MeasureStyle measure{*first_, std::move(here)};
  end();
  return measure;
}

}  // namespace rocinante
