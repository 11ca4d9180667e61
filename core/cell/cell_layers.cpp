#include "core/cell/cell_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/cell/cell_sections.h"
#include "core/cell/view_path.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

// For all layers together: members for every device (`*`) cost time at each device of each frame.
constexpr std::size_t kMaxMembers = 4096;

void readCollision(TomlTable& table, LayerLook& look) {
  const auto word = table.text("collision");
  if (!word) return;
  if (*word == "off") {
    look.collision = CollisionLook::off;
  } else if (*word == "only") {
    look.collision = CollisionLook::only;
  } else if (*word == "over") {
    look.collision = CollisionLook::over;
  } else {
    table.error("cell.unknown-word", "collision",
                fmt::format("{} is not a way to draw collision geometry", quotedInFault(*word)),
                "off, only or over");
  }
}

void readOpacity(TomlTable& table, LayerLook& look) {
  const auto opacity = table.number("opacity");
  if (!opacity) return;
  if (*opacity >= 0 && *opacity <= 1) {
    look.opacity = static_cast<float>(*opacity);
  } else {
    table.error("cell.bad-number", "opacity", "`opacity` is between 0 and 1");
  }
}

// Whether the model has a link of that name, or any link when the name is empty.
bool hasLink(const Model& model, const std::string& link) {
  return link.empty() || model.findLink(link).has_value();
}

enum class Groups : std::uint8_t { none_read, unknown, known };

Groups groupsOf(const Model& model, const LayerMember& member) {
  Groups found = Groups::none_read;
  for (const Link& link : model.links) {
    if (!member.link.empty() && link.name != member.link) continue;
    for (const Visual& visual : link.visuals) {
      if (!visual.mesh) continue;
      found = Groups::unknown;
      for (const MeshPart& part : visual.mesh->parts) {
        if (patternMatches(member.group, part.group)) return Groups::known;
      }
    }
  }
  return found;
}

bool isGhost(const Cell& cell, const std::string& device) {
  return std::ranges::any_of(
      cell.sources, [&](const CellSource& source) { return source.ghost_of.contains(device); });
}

}  // namespace

void checkLayer(const TomlTable& table, std::string_view key, const Cell& cell,
                const std::string& layer) {
  if (layer.empty() || cell.layers.empty()) return;
  std::vector<std::string_view> names;
  for (const CellLayer& known : cell.layers) {
    if (known.name == layer) return;
    names.push_back(known.name);
  }
  table.faults().warning("cell.unknown-layer", table.place(key),
                         fmt::format("no [[layer]] is named {}", quotedInFault(layer)),
                         didYouMean(layer, names));
}

void LayerReader::read(TomlTable& root) {
  for (TomlTable& table : root.tables("layer", "[[layer]]")) {
    CellLayer layer;
    const auto name = names_.take(table);
    layer.visible = table.flag("visible").value_or(true);
    layer.look.wireframe = table.flag("wireframe");
    readOpacity(table, layer.look);
    readCollision(table, layer.look);
    std::vector<const TomlNode*> at;
    readMembers(table, layer, at);
    table.finish();
    if (!name) continue;
    layer.name = *name;
    if (!at.empty()) holdings_.push_back({table, cell_.layers.size(), std::move(at)});
    cell_.layers.push_back(std::move(layer));
  }
}

void LayerReader::readMembers(TomlTable& table, CellLayer& layer,
                              std::vector<const TomlNode*>& at) {
  static_cast<void>(table.texts("members"));  // reports entries that are not strings
  const TomlNode* const array = table.node("members");
  if (array == nullptr || array->kind != TomlNode::Kind::array) return;
  for (const TomlNode& item : array->items) {
    if (item.kind != TomlNode::Kind::text) continue;
    const auto path = parseViewPath(item.text);
    if (!path.ok() || path->path.is_layer) {
      table.faults().error(
          "cell.bad-name", item.place,
          fmt::format("{} cannot be a member of a layer", quotedInFault(item.text)),
          "DEVICE, DEVICE/LINK, either with #GROUP, and * for every device");
      continue;
    }
    if (members_ == kMaxMembers) {
      table.faults().error("cell.too-many", item.place,
                           fmt::format("layers have more than {} members in all", kMaxMembers),
                           "`tags` of devices are not counted");
      return;
    }
    ++members_;
    layer.members.push_back({path->path.first, path->path.second, path->group});
    at.push_back(&item);
  }
}

void LayerReader::finish() {
  for (const Holding& holding : holdings_) {
    std::vector<LayerMember>& members = cell_.layers[holding.layer].members;
    std::vector<LayerMember> there;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (isThere(holding.table, holding.at[i]->place, members[i])) there.push_back(members[i]);
    }
    members = std::move(there);
  }
}

bool LayerReader::isThere(const TomlTable& table, Place place, const LayerMember& member) const {
  FaultList& faults = table.faults();
  std::vector<const Model*> models;
  if (member.device.empty()) {
    for (const auto& [name, model] : cell_.models) {
      if (model) models.push_back(model.get());
    }
  } else if (const CellDevice* device = cell_.findDevice(member.device)) {
    if (const Model* model = cell_.modelOf(*device)) models.push_back(model);
  } else {
    if (!isGhost(cell_, member.device)) {
      // A session may add it.
      faults.warning("cell.unknown-device", place,
                     fmt::format("`members` of [[layer]] names {}, which the cell does not have",
                                 quotedInFault(member.device)),
                     deviceHint(table, cell_, member.device));
    }
    return true;
  }
  // Models that could not be read have their own faults.
  if (models.empty()) return true;
  std::erase_if(models, [&](const Model* model) { return !hasLink(*model, member.link); });
  if (models.empty()) {
    faults.error("cell.unknown-link", place,
                 member.device.empty()
                     ? fmt::format("no device has a link {}", quotedInFault(member.link))
                     : fmt::format("device {} has no link {}", quotedInFault(member.device),
                                   quotedInFault(member.link)));
    return false;
  }
  if (member.group.empty()) return true;
  bool any_read = false;
  for (const Model* model : models) {
    const Groups groups = groupsOf(*model, member);
    if (groups == Groups::known) return true;
    any_read = any_read || groups == Groups::unknown;
  }
  if (!any_read) return true;
  faults.error("cell.unknown-group", place,
               fmt::format("{} is not a group of those meshes", quotedInFault(member.group)));
  return false;
}

}  // namespace rocinante
