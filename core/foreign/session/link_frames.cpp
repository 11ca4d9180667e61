#include "core/foreign/session/link_frames.h"

#include "core/math/transform.h"

namespace rocinante {

std::string frameName(std::string_view device, std::string_view link) {
  if (device.empty()) return std::string(kWorldFrame);
  std::string name(device);
  if (!link.empty()) name.append("/").append(link);
  return name;
}

std::vector<FramePose> deviceFrames(const PosedDevice& device) {
  const Model& model = *device.model;
  std::vector<FramePose> frames;
  frames.reserve(model.links.size() + 1);
  frames.push_back({std::string(kWorldFrame), device.name, poseOf(device.base)});
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    const auto& joint = model.links[link].parent_joint;
    const Mat4& parent = joint ? device.link_world[model.joints[*joint].parent] : device.base;
    frames.push_back({joint ? frameName(device.name, model.links[model.joints[*joint].parent].name)
                            : device.name,
                      frameName(device.name, model.links[link].name),
                      poseOf(inverseOfRigid(parent) * device.link_world[link])});
  }
  return frames;
}

}  // namespace rocinante
