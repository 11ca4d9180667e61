#pragma once

#include <optional>
#include <vector>

#include "core/math/vector.h"

namespace rocinante {

/// Where a picture is taken from: world space, metres.
struct CameraView {
  Vec3 eye{4, -4, 3}, target{0, 0, 0}, up{0, 0, 1};
  double fov_deg = 45;                   ///< vertical; from 0.01 to 179
  std::optional<double> ortho_height_m;  ///< orthographic: metres from top to bottom
  bool operator==(const CameraView&) const = default;
};

/// What GL takes as depth in clip space.
enum class ClipDepth {
  zero_to_one,       ///< after glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE): full float precision
  minus_one_to_one,  ///< GL's own
};

/// The projection of one frame, in double: 1e-6 m holds a kilometre from the origin, because the
/// eye is subtracted before anything becomes float. Depth runs from 1 at the near plane to 0 at
/// infinity (in a float, that is about equally fine at every distance), so nearer is GREATER and
/// the far side needs no plane: what is in the scene never changes another thing's depth.
class Camera {
 public:
  /// A view without a direction (eye on the target, up along the view, numbers not finite) is given
  /// one. `reach_m`: orthographic only, how far before and behind the eye things may lie.
  Camera(const CameraView& view, int width, int height, ClipDepth depth, double reach_m);

  int width() const { return width_; }
  int height() const { return height_; }
  const Vec3& eye() const { return eye_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  const Vec3& forward() const { return forward_; }
  bool orthographic() const { return orthographic_; }
  double near() const { return near_m_; }

  /// Of a world position minus eye().
  const Mat4& clipFromRelative() const { return clip_from_relative_; }
  /// `world` with the eye subtracted from its translation.
  Mat4 relative(const Mat4& world) const;

  Vec4 clipOf(const Vec3& world) const;
  /// Metres in front of the eye, along the view.
  double depthOf(const Vec3& world) const;
  /// The same from what a depth buffer holds, 1 (near) to 0; infinity for 0.
  double depthAt(double stored) const;
  /// Metres that a pixel covers at this depth.
  double metersPerPixel(double depth_m) const;
  /// False only when nothing of the sphere can be in the picture.
  bool sees(const Vec3& center, double radius) const;

 private:
  int width_, height_;
  Vec3 eye_, right_, up_, forward_;
  bool orthographic_;
  double half_width_, half_height_;  ///< at depth 1, or of the whole picture when orthographic
  double near_m_;
  double reach_m_;  ///< orthographic
  Mat4 clip_from_relative_;
};

/// A three-quarter view from front right that shows all `points` with a margin: a cell without a
/// camera. The example view when there are none.
CameraView fittedView(const std::vector<Vec3>& points, int width, int height);

/// Straight down on all `points` without perspective, with a margin: x to the right, y up. The map
/// of ten metres around the origin when there are none.
CameraView mapView(const std::vector<Vec3>& points, int width, int height);

/// `view` with its eye, target and up moved by a rigid matrix.
CameraView carriedView(const CameraView& view, const Mat4& carrier);

}  // namespace rocinante
