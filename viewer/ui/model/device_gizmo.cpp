#include "viewer/ui/model/device_gizmo.h"

#include "core/math/transform.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

/// The space that the pose of a device is in: of what carries it, else the world.
Mat4 spaceOf(const PosedScene& scene, const PosedDevice& device) {
  if (device.carrier.empty()) return Mat4(1.0);
  return scene.find(device.carrier, device.carrier_link).value_or(Mat4(1.0));
}

double metresPerPixel(const PicturePlaces& places, const Vec3& at) {
  return places.camera().metersPerPixel(places.camera().depthOf(at));
}

}  // namespace

std::optional<Gizmo> gizmoOf(const ViewModel& model, const PicturePlaces& places, double arrow_px) {
  const std::string& name = model.selected.device;
  if (!model.viewer.gizmo.shown || !model.movablePose(name).ok()) return std::nullopt;
  const PosedDevice* const device = model.scene().findDevice(name);
  if (device == nullptr) return std::nullopt;
  const Mat4 space = spaceOf(model.scene(), *device);
  Gizmo gizmo;
  gizmo.origin = positionOf(device->base);
  if (!places.pixelOf(gizmo.origin)) return std::nullopt;
  for (int i = 0; i < 3; ++i) gizmo.axes[i] = Vec3(space[i]);
  gizmo.size_m = arrow_px * metresPerPixel(places, gizmo.origin);
  return gizmo;
}

bool grabGizmo(ViewModel& model, const PicturePlaces& places, const Vec2& pixel, double arrow_px,
               double reach_px) {
  const auto gizmo = gizmoOf(model, places, arrow_px);
  if (!gizmo) return false;
  const auto handle = handleAt(*gizmo, places, pixel, reach_px);
  const auto pose = model.movablePose(model.selected.device);
  if (!handle || !pose) return false;
  model.viewer.gizmo.drag =
      GizmoDrag{model.selected.device, *handle, *gizmo, *pose, places.through(pixel)};
  return true;
}

void dragGizmo(ViewModel& model, const PicturePlaces& places, const Vec2& pixel, bool freely) {
  const GizmoState& state = model.viewer.gizmo;
  if (!state.drag) return;
  const GizmoDrag& drag = *state.drag;
  if (!model.movablePose(drag.device)) return;
  const auto change = changeOf(drag.gizmo, drag.handle, drag.grabbed, places.through(pixel));
  if (!change) return;
  const bool snaps = state.snaps && !freely;
  const GizmoSteps steps =
      snaps ? stepsAt(metresPerPixel(places, drag.gizmo.origin)) : GizmoSteps{0, 0};
  model.moves.hold(drag.device, changedPose(drag.start, drag.handle, *change, steps));
}

void releaseGizmo(ViewModel& model) {
  if (!model.viewer.gizmo.drag) return;
  model.viewer.gizmo.drag.reset();
  model.moves.settle();
}

GizmoSteps stepsAt(double metres_per_px) {
  constexpr double kApartPx = 6;
  GizmoSteps steps;
  steps.metres = 0.001;
  while (steps.metres < kApartPx * metres_per_px && steps.metres < 1000) steps.metres *= 10;
  return steps;
}

}  // namespace rocinante
