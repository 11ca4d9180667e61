#include "viewer/render/view_choice.h"

#include <algorithm>

namespace rocinante {

Result<ViewChoice> ViewChoice::make(const std::vector<std::string>& hide,
                                    const std::vector<std::string>& show) {
  ViewChoice choice;
  for (const auto* list : {&show, &hide}) {
    for (const std::string& text : *list) {
      const Result<ViewPath> path = parseViewPath(text);
      if (!path) return path.error();
      const bool visible = list == &show;
      if (path->has_group) {
        const int nearness = (path->path.second.empty() ? 0 : 2) + (path->all_devices ? 0 : 1);
        choice.parts_.push_back({*path, visible, nearness});
      } else {
        choice.visible_[path->path] = visible;
      }
    }
  }
  std::stable_sort(
      choice.parts_.begin(), choice.parts_.end(), [](const PartChoice& a, const PartChoice& b) {
        return a.nearness != b.nearness ? a.nearness > b.nearness : a.visible < b.visible;
      });
  return choice;
}

bool ViewChoice::linkVisible(const PosedDevice& device, std::size_t link) const {
  if (!visible_.empty()) {
    const std::string& link_name = device.model->links[link].name;
    for (const Path& path :
         {Path{false, device.name, link_name}, Path{false, {}, link_name},
          Path{false, device.name, {}}, Path{true, "layer", device.layer}, Path{}}) {
      const auto found = visible_.find(path);
      if (found != visible_.end()) return found->second;
    }
  }
  return device.visible && device.link_visible[link];
}

bool ViewChoice::partVisible(const PosedDevice& device, std::size_t link,
                             std::string_view group) const {
  for (const PartChoice& part : parts_) {
    if (part.path.namesPart(device, link, group)) return part.visible;
  }
  return linkVisible(device, link);
}

bool ViewChoice::layerVisible(std::string_view layer) const {
  const auto found = visible_.find(Path{true, "layer", std::string(layer)});
  return found == visible_.end() || found->second;
}

}  // namespace rocinante
