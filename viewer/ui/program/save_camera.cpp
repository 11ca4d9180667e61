#include "viewer/ui/program/save_camera.h"

#include <utility>

#include "viewer/ui/model/camera_append.h"

namespace rocinante {

Status saveCamera(ViewModel& model, const std::filesystem::path& cell_file,
                  const std::string& name) {
  const CameraView view = model.cameraView();
  CellCamera camera;
  camera.name = name;
  camera.eye = view.eye;
  camera.target = view.target;
  camera.up = view.up;
  camera.fov_deg = view.fov_deg;
  camera.ortho_height_m = view.ortho_height_m;
  if (auto appended = appendCamera(cell_file, camera); !appended) return appended;
  model.addCamera(std::move(camera));
  return {};
}

}  // namespace rocinante
