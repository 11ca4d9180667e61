#include "viewer/render/camera_choice.h"

namespace rocinante {

CameraView viewOf(const PosedCamera& camera) {
  return {camera.eye, camera.target, camera.up, camera.fov_deg, camera.ortho_height_m};
}

Result<CameraView> chooseCamera(const std::string& name, const PosedScene& scene) {
  if (const PosedCamera* camera = scene.findCamera(name)) return viewOf(*camera);
  std::string names;
  for (const PosedCamera& camera : scene.cameras)
    names += (names.empty() ? "" : ", ") + camera.name;
  return Error{ErrorKind::not_found,
               "no camera is called `" + name +
                   "`: " + (names.empty() ? "there is none" : "there are " + names),
               {}};
}

}  // namespace rocinante
