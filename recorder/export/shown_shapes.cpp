#include "recorder/export/shown_shapes.h"

#include <algorithm>

#include "core/foreign/session/link_frames.h"
#include "recorder/gltf/gltf_link.h"

namespace rocinante {

Result<std::shared_ptr<const Bytes>> ShownShapes::shapeOf(const PosedDevice& device,
                                                          std::size_t link) {
  const auto [known, is_new] =
      shapes_.try_emplace({device.name, device.model, link, device.link_color[link]});
  if (!is_new) return known->second;
  std::vector<std::string> missing;
  Result<Bytes> glb = gltfOfLink(device, link, missing);
  if (!glb) return glb.error();
  for (std::string& gap : missing) {
    if (std::find(gaps_.begin(), gaps_.end(), gap) == gaps_.end()) gaps_.push_back(std::move(gap));
  }
  known->second = std::make_shared<const Bytes>(std::move(*glb));
  return known->second;
}

Status ShownShapes::write(LogTime time, const PosedDevice& device) {
  std::vector<LinkShape> shapes;
  for (std::size_t link = 0; link < device.model->links.size(); ++link) {
    if (!device.link_visible[link]) continue;
    const Result<std::shared_ptr<const Bytes>> glb = shapeOf(device, link);
    if (!glb) return glb.error();
    if ((*glb)->empty()) continue;
    shapes.push_back({frameName(device.name, device.model->links[link].name), *glb});
  }
  return format_.shapes(out_, time, device.name, shapes);
}

Status ShownShapes::moment(LogTime time, const PosedScene& scene) {
  for (const PosedDevice& device : scene.devices) {
    if (device.ghost) continue;
    Look now{device.model, device.link_visible, device.link_color};
    Look& known = looks_[device.name];
    if (known == now) continue;
    known = std::move(now);
    if (Status written = write(time, device); !written) return written;
  }
  for (auto& [name, look] : looks_) {
    const PosedDevice* const device = scene.findDevice(name);
    if (look.model == nullptr || (device != nullptr && !device->ghost)) continue;
    look = {};
    if (Status written = format_.shapes(out_, time, name, {}); !written) return written;
  }
  return {};
}

}  // namespace rocinante
