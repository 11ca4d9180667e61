#pragma once

#include <optional>
#include <string>

#include "viewer/ui/model/gizmo.h"

namespace rocinante {

class ViewModel;

/// How long an arrow is, and how near to a handle takes hold of it; at scale 1.
constexpr double kGizmoArrowPx = 90;
constexpr double kGizmoReachPx = 8;

/// A handle of the gizmo that the mouse holds.
struct GizmoDrag {
  std::string device;
  GizmoHandle handle;
  Gizmo gizmo;  ///< as it was when it was grabbed
  Pose start;   ///< of the device then
  SightLine grabbed;
};

/// The gizmo of the selected device, and what of it the mouse holds. Plain values.
struct GizmoState {
  bool shown = false;
  bool snaps = true;
  std::optional<GizmoDrag> drag;
};

/// The handles of the selected device, along the axes of the space that its pose is in; empty when
/// the gizmo is off, and for what cannot be moved by hand. `arrow_px`: how long an arrow is.
std::optional<Gizmo> gizmoOf(const ViewModel& model, const PicturePlaces& places, double arrow_px);

/// Takes hold of the handle at the pixel, if there is one.
bool grabGizmo(ViewModel& model, const PicturePlaces& places, const Vec2& pixel, double arrow_px,
               double reach_px);
/// The mouse is there now. `freely`: without steps.
void dragGizmo(ViewModel& model, const PicturePlaces& places, const Vec2& pixel, bool freely);
/// Lets go: one step to undo.
void releaseGizmo(ViewModel& model);

/// The steps at this scale: of 1, 10 or 100 mm and so on, at least six pixels apart, and 5 degrees.
GizmoSteps stepsAt(double metres_per_px);

}  // namespace rocinante
