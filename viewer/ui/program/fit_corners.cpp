#include "viewer/ui/program/fit_corners.h"

namespace rocinante {
namespace {

std::vector<Vec3> cornersOf(const Bounds& bounds) {
  if (bounds.empty()) return {};
  return {bounds.min, bounds.max};
}

}  // namespace

std::vector<Vec3> cornersToFit(const ViewModel& model, const Renderer& renderer,
                               const FittedCameras& fitted) {
  const DeviceNames movable = fitted.movable(model.scene());
  const Bounds bounds = renderer.visibleBounds(model.scene(), model.choice(), &movable);
  if (!bounds.empty()) return cornersOf(bounds);
  return cornersOf(renderer.visibleBounds(model.scene(), model.choice()));
}

std::vector<Vec3> selectedCorners(const ViewModel& model, const Renderer& renderer,
                                  const FittedCameras& fitted) {
  if (model.selected.device.empty()) return cornersToFit(model, renderer, fitted);
  const auto alone = ViewChoice::make({"*"}, {model.selected.path()});
  if (!alone.ok()) return {};
  return cornersOf(renderer.visibleBounds(model.scene(), *alone));
}

}  // namespace rocinante
