#include "core/cell/device_appearance.h"

#include <algorithm>
#include <map>

#include "core/base/pattern.h"

namespace rocinante {
namespace {

// The packets' settings for one path, if any.
template <class T>
const T* statedOf(const std::map<Path, Item<T>>& items, bool is_layer, std::string_view first) {
  const auto found = items.find(Path{is_layer, is_layer ? "layer" : std::string(first),
                                     is_layer ? std::string(first) : std::string()});
  return found == items.end() ? nullptr : &found->second.value;
}

bool shown(const Visibility* visibility, bool by_default) {
  if (visibility == nullptr || visibility->kind == Visibility::Kind::by_default) return by_default;
  return visibility->kind == Visibility::Kind::shown;
}

}  // namespace

// How the links of a device are drawn unless one has settings of its own.
struct DeviceAppearance::Whole {
  bool visible = true;
  Own color;
  bool recolored = false;  // by packets
  LayerLook look{};

  void add(const PosedShare& share) {
    visible = visible && share.visible;
    if (share.has_color) {
      color = share.color;
      recolored = share.recolors;
    }
    look.add(share.look);
  }
};

PosedShare DeviceAppearance::shareOf(std::string_view name, const CellLayer* listed,
                                     const Own& own) const {
  PosedShare share;
  share.layer = name;
  share.visible =
      shown(statedOf(state_.visibility(), true, name), listed == nullptr || listed->visible);
  if (const ColorValue* value = statedOf(state_.colors(), true, name)) {
    share.has_color = true;
    share.recolors = value->rgba.has_value();
    share.color = value->rgba ? value->rgba : own;
  }
  if (listed != nullptr) share.look = listed->look;
  return share;
}

void DeviceAppearance::addMembers(PosedDevice& device, std::string_view name,
                                  const Own& own) const {
  for (const LayerShare& found : layers_.sharesOf(name)) {
    const LayerMember& member = *found.member;
    const auto link = member.link.empty() ? std::nullopt : device.model->findLink(member.link);
    if (!member.link.empty() && !link) continue;
    PosedShare& share = device.shares.emplace_back(shareOf(found.layer, found.listed, own));
    share.link = link;
    share.group = member.group;
    device.has_parts = device.has_parts || share.ofParts();
  }
}

void DeviceAppearance::addShares(PosedDevice& device, const Own& own,
                                 const CellDevice* of_cell) const {
  if (of_cell != nullptr) {
    for (const std::string& tag : of_cell->tags) {
      device.shares.push_back(shareOf(tag, layers_.find(tag), own));
    }
    addMembers(device, of_cell->name, own);
  }
  if (of_cell == nullptr || device.ghost) addMembers(device, device.name, own);
}

void DeviceAppearance::dress(PosedDevice& device, std::optional<std::uint32_t> own,
                             const CellDevice* of_cell) const {
  addShares(device, own, of_cell);
  Whole whole;
  whole.color = own;
  if (!device.layer.empty()) whole.add(shareOf(device.layer, layers_.find(device.layer), own));
  bool any_look = whole.look != LayerLook();
  for (const PosedShare& share : device.shares) {
    if (!share.link && !share.ofParts()) whole.add(share);
    any_look = any_look || share.look != LayerLook();
  }
  whole.visible = whole.visible && shown(statedOf(state_.visibility(), false, device.name), true);
  if (const ColorValue* value = statedOf(state_.colors(), false, device.name)) {
    whole.color = value->rgba ? value->rgba : own;
    whole.recolored = value->rgba.has_value();
  }
  const std::size_t links = device.model->links.size();
  device.visible = whole.visible;
  device.link_visible.assign(links, whole.visible);
  device.link_color.assign(links, whole.color);
  if (any_look) {
    device.link_look.assign(links, whole.look);
    device.link_recolored.assign(links, whole.recolored);
  }
  dressByLayers(device);
  dressBySession(device, own);
}

void DeviceAppearance::dressByLayers(PosedDevice& device) const {
  for (const PosedShare& share : device.shares) {
    if (!share.link || share.ofParts()) continue;
    const std::size_t l = *share.link;
    device.link_visible[l] = device.link_visible[l] && share.visible;
    if (share.has_color) device.link_color[l] = share.color;
    if (device.link_look.empty()) continue;
    device.link_look[l].add(share.look);
    if (share.has_color) device.link_recolored[l] = share.recolors;
  }
}

// Only paths of links of this device: a range of the ordered paths.
void DeviceAppearance::dressBySession(PosedDevice& device, const Own& own) const {
  const Path begin{false, device.name, {}};
  for (auto it = state_.visibility().upper_bound(begin);
       it != state_.visibility().end() && !it->first.is_layer && it->first.first == device.name;
       ++it) {
    const auto link = device.model->findLink(it->first.second);
    if (!link) continue;
    device.link_visible[*link] = device.link_visible[*link] && shown(&it->second.value, true);
  }
  for (auto it = state_.colors().upper_bound(begin);
       it != state_.colors().end() && !it->first.is_layer && it->first.first == device.name; ++it) {
    const auto link = device.model->findLink(it->first.second);
    if (!link) continue;
    const ColorValue& value = it->second.value;
    device.link_color[*link] = value.rgba ? value.rgba : own;
    if (!device.link_recolored.empty()) device.link_recolored[*link] = value.rgba.has_value();
  }
}

bool PosedShare::holdsPart(std::size_t of_link, std::string_view part_group) const {
  return ofParts() && (!link || *link == of_link) && patternMatches(group, part_group);
}

bool PosedDevice::inLayer(std::string_view wanted, std::size_t link) const {
  if (layer == wanted) return true;
  return std::ranges::any_of(
      shares, [&](const PosedShare& share) { return share.layer == wanted && share.holds(link); });
}

bool PosedDevice::partVisible(std::size_t link, std::string_view group) const {
  if (!link_visible[link]) return false;
  return !has_parts || std::ranges::all_of(shares, [&](const PosedShare& share) {
    return share.visible || !share.holdsPart(link, group);
  });
}

std::optional<std::uint32_t> PosedDevice::partColor(std::size_t link,
                                                    std::string_view group) const {
  std::optional<std::uint32_t> color = link_color[link];
  if (!has_parts) return color;
  for (const PosedShare& share : shares) {
    if (share.has_color && share.holdsPart(link, group)) color = share.color;
  }
  return color;
}

LayerLook PosedDevice::partLook(std::size_t link, std::string_view group) const {
  if (link_look.empty()) return {};
  LayerLook look = link_look[link];
  bool recolored = link_recolored[link];
  for (const PosedShare& share : shares) {
    if (!has_parts || !share.holdsPart(link, group)) continue;
    look.add(share.look);
    if (share.has_color) recolored = share.recolors;
  }
  if (recolored) look.opacity.reset();
  return look;
}

}  // namespace rocinante
