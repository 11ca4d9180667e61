#pragma once

#include <optional>
#include <string>

#include "core/cell/posed_scene.h"
#include "core/math/vector.h"
#include "viewer/ui/model/selection.h"
#include "viewer/view/measure_style.h"

namespace rocinante {

/// The pose of a device's or link's space in another's; `in` without a device: in the world. Empty
/// when one of them is not in the scene.
std::optional<Pose> poseIn(const PosedScene& scene, const Selection& what, const Selection& in);

/// Fixed-axis roll, pitch, yaw of a unit quaternion in radians, as URDF has them
/// (quaternionFromRpy). At a pitch of +-90 degrees the roll is 0.
Vec3 rpyOf(const Quat& rotation);

/// Two clicks on surfaces make a distance that moves with what was clicked.
class DistancePicking {
 public:
  bool active() const { return active_; }
  const std::optional<MeasurePoint>& first() const { return first_; }
  void begin() {
    active_ = true;
    first_.reset();
  }
  void end() {
    active_ = false;
    first_.reset();
  }

  /// Takes a clicked point on a link, in the world; the distance when it is the second one, which
  /// ends picking. Ignored for a link that is not in the scene.
  std::optional<MeasureStyle> add(const PosedScene& scene, const Selection& link,
                                  const Vec3& point);

 private:
  bool active_ = false;
  std::optional<MeasurePoint> first_;
};

}  // namespace rocinante
