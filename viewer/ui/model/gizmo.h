#pragma once

#include <optional>
#include <vector>

#include "core/math/vector.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A line of sight, from the eye on. `way` need not be of unit length.
struct SightLine {
  Vec3 from{0, 0, 0}, way{1, 0, 0};
};

/// What of the world is where in a picture, and back.
class PicturePlaces {
 public:
  /// `view` in a picture of that size, in pixels.
  PicturePlaces(const CameraView& view, int width, int height)
      : camera_(view, width, height, ClipDepth::zero_to_one, 1) {}

  const Camera& camera() const { return camera_; }
  /// In pixels from the picture's top left; empty behind the eye.
  std::optional<Vec2> pixelOf(const Vec3& world) const;
  SightLine through(const Vec2& pixel) const;

 private:
  Camera camera_;
};

/// What can be held of a gizmo: an arrow moves along its axis, a square in the plane across its
/// axis, a ring turns about its axis.
struct GizmoHandle {
  enum class Kind { arrow, square, ring };
  Kind kind = Kind::arrow;
  int axis = 0;  ///< 0 to 2
  bool operator==(const GizmoHandle&) const = default;
};

/// Handles about a place, along the axes of a space.
struct Gizmo {
  Vec3 origin{0, 0, 0};
  Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< of unit length, in the world
  double size_m = 1;                                 ///< of an arrow
};

/// One handle as it is drawn: corners in the world, the last one joined to the first unless it is
/// an arrow.
std::vector<Vec3> outlineOf(const Gizmo& gizmo, const GizmoHandle& handle);
/// The nearest handle within `reach_px` of the pixel; squares come first inside. Pure.
std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const PicturePlaces& places,
                                    const Vec2& pixel, double reach_px);

/// Where the line is nearest to an axis through `origin`, in metres along it; empty when it runs
/// along the axis. Pure.
std::optional<double> placeOnAxis(const SightLine& line, const Vec3& origin, const Vec3& axis);
/// Where the line meets the plane through `origin`; empty when it runs along the plane, or meets it
/// behind the eye. Pure.
std::optional<Vec3> placeOnPlane(const SightLine& line, const Vec3& origin, const Vec3& normal);

/// How a drag changes a pose: along or about the gizmo's axes.
struct GizmoChange {
  Vec3 moved{0, 0, 0};  ///< metres along each axis
  double turned = 0;    ///< radians about the handle's axis, of a ring
};
/// Of a drag from one line of sight to another with the handle in hand; empty when that has no
/// place on it. Pure.
std::optional<GizmoChange> changeOf(const Gizmo& gizmo, const GizmoHandle& handle,
                                    const SightLine& from, const SightLine& to);

/// Steps of a grid; 0: none.
struct GizmoSteps {
  double metres = 0.01;
  double radians = 0.0872664625997165;  ///< 5 degrees
};
/// `start` with the change of a handle, whose axes are those of the pose's space. What moves comes
/// to whole steps of its space, what turns turns by whole steps. Pure.
Pose changedPose(const Pose& start, const GizmoHandle& handle, const GizmoChange& change,
                 const GizmoSteps& steps);

}  // namespace rocinante
