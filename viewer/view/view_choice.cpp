#include "viewer/view/view_choice.h"

#include <algorithm>
#include <array>

#include "core/cell/layer_index.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr std::array kBuiltIn{"gnomon", "grid", "labels", "lines", "points"};

}  // namespace

KnownLayers knownLayers(const Cell& cell) {
  KnownLayers known = layerNames(cell);
  known.insert(kBuiltIn.begin(), kBuiltIn.end());
  return known;
}

void chooseLayers(const std::vector<std::string>& layers, std::vector<std::string>& hide,
                  std::vector<std::string>& show) {
  hide.emplace_back("*");
  for (const char* name : kBuiltIn) {
    if (std::ranges::find(layers, name) == layers.end()) {
      hide.push_back(std::string("layer/") + name);
    }
  }
  // Built-in layers contain no device: they are visible unless hidden.
  for (const std::string& layer : layers) show.push_back("layer/" + encodeName(layer));
}

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
        choice.names_links_ =
            choice.names_links_ || (!path->path.is_layer && !path->path.second.empty());
      }
    }
  }
  std::stable_sort(
      choice.parts_.begin(), choice.parts_.end(), [](const PartChoice& a, const PartChoice& b) {
        return a.nearness != b.nearness ? a.nearness > b.nearness : a.visible < b.visible;
      });
  return choice;
}

std::optional<bool> ViewChoice::chosen(const Path& path) const {
  const auto found = visible_.find(path);
  return found == visible_.end() ? std::nullopt : std::optional(found->second);
}

template <class Holds>
std::optional<bool> ViewChoice::chosenByLayers(const PosedDevice& device,
                                               const Holds& holds) const {
  std::optional<bool> visible;
  for (const PosedShare& share : device.shares) {
    if (!holds(share)) continue;
    const auto by_layer = chosen(Path{true, "layer", std::string(share.layer)});
    if (by_layer) visible = *by_layer && visible.value_or(true);
  }
  return visible;
}

std::optional<bool> ViewChoice::chosen(const PosedDevice& device, std::size_t link,
                                       std::optional<bool> whole) const {
  if (visible_.empty()) return std::nullopt;
  if (names_links_) {
    const std::string& link_name = device.model->links[link].name;
    if (const auto own = chosen(Path{false, device.name, link_name})) return own;
    if (const auto so_called = chosen(Path{false, {}, link_name})) return so_called;
  }
  const auto by_layers = chosenByLayers(
      device, [&](const PosedShare& share) { return share.link && share.holds(link); });
  return by_layers ? by_layers : whole;
}

std::optional<bool> ViewChoice::chosenWhole(const PosedDevice& device) const {
  if (visible_.empty()) return std::nullopt;
  if (const auto whole = chosen(Path{false, device.name, {}})) return whole;
  auto by_layer = chosenByLayers(
      device, [](const PosedShare& share) { return !share.link && !share.ofParts(); });
  if (const auto its_own = chosen(Path{true, "layer", device.layer})) {
    by_layer = *its_own && by_layer.value_or(true);
  }
  if (by_layer) return by_layer;
  return chosen(Path{});
}

bool ViewChoice::partVisible(const PosedDevice& device, std::size_t link,
                             std::string_view group) const {
  for (const PartChoice& part : parts_) {
    if (part.path.namesPart(device, link, group)) return part.visible;
  }
  if (!device.has_parts) return linkVisible(device, link);
  const auto by_layers =
      chosenByLayers(device, [&](const PosedShare& share) { return share.holdsPart(link, group); });
  if (by_layers) return *by_layers;
  return chosen(device, link, chosenWhole(device))
      .value_or(device.visible && device.partVisible(link, group));
}

bool ViewChoice::layerVisible(std::string_view layer) const {
  const auto found = visible_.find(Path{true, "layer", std::string(layer)});
  return found == visible_.end() || found->second;
}

}  // namespace rocinante
