#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/cell/camera_lens.h"
#include "core/math/vector.h"

namespace rocinante {

/// Where a calibrated picture lies in a drawn one: as large as fits, in the middle. Its left edge,
/// half a pixel before the centre of its pixel 0, is at `left`.
struct LensFit {
  double left = 0, top = 0;  ///< in pixels of the drawn picture
  double scale = 1;          ///< pixels of the drawn picture per calibrated one

  double right(const CameraIntrinsics& lens) const { return left + scale * lens.width; }
  double bottom(const CameraIntrinsics& lens) const { return top + scale * lens.height; }
};

inline LensFit fitOf(const CameraIntrinsics& lens, int width, int height) {
  const double scale =
      std::min(static_cast<double>(width) / lens.width, static_cast<double>(height) / lens.height);
  return {(width - scale * lens.width) / 2, (height - scale * lens.height) / 2, scale};
}

/// The view of a picture in world space, metres.
struct CameraView {
  Vec3 eye{4, -4, 3}, target{0, 0, 0}, up{0, 0, 1};
  double fov_deg = 45;                   ///< vertical; from 0.01 to 179
  std::optional<double> ortho_height_m;  ///< orthographic: metres from top to bottom
  /// Of a calibrated camera, in place of `fov_deg`: its picture lies in the drawn one by fitOf(),
  /// and the scene continues around it. Ignored when orthographic.
  std::optional<CameraIntrinsics> intrinsics{};
  bool operator==(const CameraView&) const = default;
};

/// GL's depth range in clip space.
enum class ClipDepth {
  zero_to_one,       ///< after glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE): full float precision
  minus_one_to_one,  ///< GL's default
};

/// The projection of one frame, in double: precise to 1e-6 m a kilometre from the origin, because
/// the eye is subtracted before converting to float. Depth runs from 1 at the near plane to 0 at
/// infinity (in float, with about equal relative precision at every distance), so nearer is GREATER
/// and there is no far plane: objects do not change each other's depth.
class Camera {
 public:
  /// A view without a direction (eye on the target, up along the view, values not finite) gets one.
  /// `reach_m`: orthographic only, the largest distance in front of and behind the eye.
  Camera(const CameraView& view, int width, int height, ClipDepth depth, double reach_m);

  int width() const { return width_; }
  int height() const { return height_; }
  const Vec3& eye() const { return eye_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  const Vec3& forward() const { return forward_; }
  bool orthographic() const { return orthographic_; }
  double near() const { return near_m_; }

  /// Maps a world position minus eye() to clip space.
  const Mat4& clipFromRelative() const { return clip_from_relative_; }
  /// `world` with the eye subtracted from its translation.
  Mat4 relative(const Mat4& world) const;

  Vec4 clipOf(const Vec3& world) const;
  /// Metres in front of the eye, along the view.
  double depthOf(const Vec3& world) const;
  /// The same from a depth buffer's value, 1 (near) to 0; infinity for 0.
  double depthAt(double stored) const;
  /// Metres per pixel at this depth, upwards.
  double metersPerPixel(double depth_m) const;
  /// Metres per pixel to the right, as a part of those upwards.
  double pixelAspect() const { return pixel_aspect_; }
  /// Where the line of sight meets the picture, from -1 to 1 to the right and upwards: 0, 0 but for
  /// a calibrated lens.
  const Vec2& center() const { return center_; }
  /// False only when the sphere is entirely outside the picture.
  bool sees(const Vec3& center, double radius) const;

 private:
  int width_, height_;
  Vec3 eye_, right_, up_, forward_;
  bool orthographic_;
  double half_width_, half_height_;  ///< at depth 1, or of the whole picture when orthographic
  double pixel_aspect_ = 1;
  Vec2 center_{0, 0};
  double near_m_;
  double reach_m_;  ///< orthographic
  Mat4 clip_from_relative_;
};

/// A three-quarter view from front right that shows all `points` with a margin, for a cell without
/// a camera. A default view without points.
CameraView fittedView(const std::vector<Vec3>& points, int width, int height);

/// An orthographic view straight down on all `points` with a margin: x to the right, y up. Ten
/// metres around the origin without points.
CameraView mapView(const std::vector<Vec3>& points, int width, int height);

/// `view` with its eye, target and up moved by a rigid matrix.
CameraView carriedView(const CameraView& view, const Mat4& carrier);

}  // namespace rocinante
