#include "core/cell/layer_index.h"

#include <algorithm>

namespace rocinante {

std::set<std::string, std::less<>> layerNames(const Cell& cell) {
  std::set<std::string, std::less<>> names;
  for (const CellLayer& layer : cell.layers) names.insert(layer.name);
  for (const CellDevice& device : cell.devices) {
    if (!device.layer.empty()) names.insert(device.layer);
    names.insert(device.tags.begin(), device.tags.end());
  }
  return names;
}

LayerIndex::LayerIndex(const Cell& cell) : cell_(&cell) {
  for (std::size_t l = 0; l < cell.layers.size(); ++l) {
    const CellLayer& layer = cell.layers[l];
    by_name_.emplace(layer.name, l);
    for (std::size_t i = 0; i < layer.members.size(); ++i) {
      const std::string& device = layer.members[i].device;
      (device.empty() ? of_all_ : by_device_[device]).push_back({l, i});
    }
  }
}

const CellLayer* LayerIndex::find(std::string_view layer) const {
  const auto found = by_name_.find(layer);
  return found == by_name_.end() ? nullptr : &cell_->layers[found->second];
}

std::vector<LayerShare> LayerIndex::sharesOf(std::string_view device) const {
  std::vector<Member> members = of_all_;
  if (const auto own = by_device_.find(device); own != by_device_.end()) {
    members.insert(members.end(), own->second.begin(), own->second.end());
    std::sort(members.begin(), members.end());
  }
  std::vector<LayerShare> shares;
  for (const Member& at : members) {
    const CellLayer& layer = cell_->layers[at.layer];
    shares.push_back({layer.name, &layer, &layer.members[at.number]});
  }
  return shares;
}

}  // namespace rocinante
