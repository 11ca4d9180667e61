#include "core/cell/posed_scene.h"

namespace rocinante {

const PosedDevice* PosedScene::findDevice(std::string_view name) const {
  const auto found = device_by_name.find(name);
  return found == device_by_name.end() ? nullptr : &devices[found->second];
}

const PosedCamera* PosedScene::findCamera(std::string_view name) const {
  for (auto camera = cameras.rbegin(); camera != cameras.rend(); ++camera) {
    if (camera->name == name) return &*camera;
  }
  return nullptr;
}

std::optional<Mat4> PosedScene::find(std::string_view device, std::string_view link) const {
  const PosedDevice* posed = findDevice(device);
  if (posed == nullptr) return std::nullopt;
  if (link.empty()) return posed->base;
  const auto found = posed->model->findLink(link);
  if (!found) return std::nullopt;
  return posed->link_world[*found];
}

}  // namespace rocinante
