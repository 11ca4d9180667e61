#pragma once

#include <vector>

#include "viewer/view/camera.h"

namespace rocinante {

/// A camera that turns about a target, z up, moved by the mouse. Pure; angles in radians, lengths
/// in metres, drags in pixels (x right, y down).
class Turntable {
 public:
  Turntable() = default;
  /// Starts at `view`, so that nothing jumps when the mouse takes over. A view from straight above
  /// or with another up axis keeps its eye and target and gets z up.
  explicit Turntable(const CameraView& view);

  CameraView view() const;

  /// A drag over the whole height turns by pi.
  void orbit(double dx_px, double dy_px, int height_px);
  /// The point under the mouse stays under it, at the target's distance.
  void pan(double dx_px, double dy_px, int height_px);
  /// One step nearer (positive) is a tenth of the distance.
  void zoom(double steps);
  /// The same, keeping the point at `right_px` and `down_px` from the picture's centre in place, at
  /// the target's distance.
  void zoomAt(double steps, double right_px, double down_px, int height_px);
  /// Turns about `point` from now on, with the same direction and distance.
  void aimAt(const Vec3& point) { target_ = point; }
  /// Moves eye and target.
  void shift(const Vec3& by) { target_ += by; }
  /// Moves eye and target, in metres: to the right, where the view looks, and upwards in the world.
  /// An orthographic view moves up in the picture instead of forward, and its height grows upwards.
  void fly(double right_m, double forward_m, double up_m);
  /// The eye stays and looks elsewhere: with a drag to the right, to the right. A drag over the
  /// whole height turns by pi / 2.
  void lookAround(double dx_px, double dy_px, int height_px);
  /// Looks at the target from that direction, of any length. From straight above or below x is to
  /// the right.
  void lookFrom(const Vec3& direction);
  /// Shows all `points` from the present direction. Does nothing without points.
  void fit(const std::vector<Vec3>& points, int width_px, int height_px);

 private:
  Vec3 direction() const;  ///< from the target to the eye, unit length
  double heightM() const;  ///< of what is seen at the target's distance

  Vec3 target_{0, 0, 0};
  double distance_m_ = 5;
  double azimuth_rad_ = -0.8;   ///< of the eye about z, from x
  double elevation_rad_ = 0.6;  ///< of the eye above the target
  double fov_deg_ = 45;
  std::optional<double> ortho_height_m_;
};

}  // namespace rocinante
