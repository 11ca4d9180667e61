#include "viewer/ui/model/shown_layers.h"

#include <functional>
#include <map>
#include <string_view>

namespace rocinante {
namespace {

void add(ShownPart& sum, bool visible) {
  const ShownPart one = visible ? ShownPart::all : ShownPart::hidden;
  sum = sum == ShownPart::nothing || sum == one ? one : ShownPart::some;
}

/// The groups of a link's meshes: what layers of parts hold.
void forEachGroup(const Link& link, const std::function<void(std::string_view)>& meet) {
  for (const Visual& visual : link.visuals) {
    if (visual.mesh == nullptr) continue;
    for (const MeshPart& part : visual.mesh->parts) meet(part.group);
  }
}

}  // namespace

const char* nameOf(ShownPart part) {
  switch (part) {
    case ShownPart::nothing:
      return "nothing to show";
    case ShownPart::hidden:
      return "hidden";
    case ShownPart::some:
      return "partly shown";
    case ShownPart::all:
      break;
  }
  return "shown";
}

ShownPart shownLink(const PosedDevice& device, std::size_t link, const ViewChoice& choice) {
  ShownPart sum = ShownPart::nothing;
  if (device.model->links[link].visuals.empty()) return sum;
  if (!choice.choosesParts(device)) {
    add(sum, choice.linkVisible(device, link));
    return sum;
  }
  forEachGroup(device.model->links[link],
               [&](std::string_view group) { add(sum, choice.partVisible(device, link, group)); });
  return sum;
}

ShownPart shownDevice(const PosedDevice& device, const ViewChoice& choice) {
  ShownPart sum = ShownPart::nothing;
  if (device.model == nullptr) return sum;
  for (std::size_t link = 0; link < device.model->links.size(); ++link) {
    const ShownPart one = shownLink(device, link, choice);
    if (one == ShownPart::nothing) continue;
    if (sum != ShownPart::nothing && sum != one) return ShownPart::some;
    sum = one;
  }
  return sum;
}

std::vector<ShownPart> shownLayers(const Cell& cell, const PosedScene& scene,
                                   const ViewChoice& choice) {
  std::vector<ShownPart> shown(cell.layers.size(), ShownPart::nothing);
  std::map<std::string_view, std::size_t> numbers;
  for (std::size_t i = 0; i < cell.layers.size(); ++i) numbers.emplace(cell.layers[i].name, i);
  const auto meet = [&](std::string_view layer, bool visible) {
    const auto number = numbers.find(layer);
    if (number != numbers.end()) add(shown[number->second], visible);
  };
  for (const PosedDevice& device : scene.devices) {
    if (device.model == nullptr) continue;
    const bool by_parts = choice.choosesParts(device);
    const std::optional<bool> whole = choice.chosenWhole(device);
    for (std::size_t i = 0; i < device.model->links.size(); ++i) {
      const Link& link = device.model->links[i];
      if (link.visuals.empty()) continue;
      if (!by_parts) {
        const bool visible = choice.linkVisible(device, i, whole);
        meet(device.layer, visible);
        for (const PosedShare& share : device.shares) {
          if (share.holds(i)) meet(share.layer, visible);
        }
        continue;
      }
      forEachGroup(link, [&](std::string_view group) {
        const bool visible = choice.partVisible(device, i, group);
        meet(device.layer, visible);
        for (const PosedShare& share : device.shares) {
          if (share.holds(i) || share.holdsPart(i, group)) meet(share.layer, visible);
        }
      });
    }
  }
  return shown;
}

}  // namespace rocinante
