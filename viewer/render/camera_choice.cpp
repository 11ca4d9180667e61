#include "viewer/render/camera_choice.h"

#include <vector>

#include "core/math/transform.h"

namespace rocinante {
namespace {

Result<CameraView> place(const CameraView& view, const std::string& name, const PosedScene& scene,
                         const std::string& device, const std::string& link, bool turns) {
  const std::optional<Mat4> carrier = scene.find(device, link);
  if (!carrier) {
    return Error{ErrorKind::not_found,
                 "camera `" + name + "` is carried by " + device +
                     (link.empty() ? std::string() : "/" + link) +
                     ", which is not there at this moment",
                 {}};
  }
  return carriedView(view, turns ? *carrier : translationMatrix(positionOf(*carrier)));
}

std::string listed(const Cell& cell, const SessionState& state) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (const CellCamera& camera : cell.cameras) add(camera.name);
  for (const auto& [name, view] : state.views()) add(name);
  return names.empty() ? "there is none" : "there are " + names;
}

}  // namespace

Result<CameraView> placeCamera(const CellCamera& camera, const PosedScene& scene) {
  const CameraView view{camera.eye, camera.target, camera.up, camera.fov_deg,
                        camera.ortho_height_m};
  if (!camera.on_device.empty()) {
    return place(view, camera.name, scene, camera.on_device, camera.on_link, true);
  }
  if (!camera.follow_device.empty()) {
    return place(view, camera.name, scene, camera.follow_device, camera.follow_link, false);
  }
  return view;
}

Result<CameraView> chooseCamera(const std::string& name, const Cell& cell,
                                const SessionState& state, const PosedScene& scene) {
  if (const CellCamera* camera = cell.findCamera(name)) return placeCamera(*camera, scene);
  const auto found = state.views().find(name);
  if (found == state.views().end()) {
    return Error{
        ErrorKind::not_found, "no camera is called `" + name + "`: " + listed(cell, state), {}};
  }
  const ViewValue& value = found->second.value;
  const CameraView view{value.eye, value.target, value.up, value.fov_deg, value.ortho_height_m};
  if (value.carrier.first.empty()) return view;
  return place(view, name, scene, value.carrier.first, value.carrier.second, true);
}

}  // namespace rocinante
