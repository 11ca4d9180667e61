#include "viewer/view/known_names.h"

#include <algorithm>
#include <memory>

#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/cell/layer_index.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"
#include "viewer/view/beside_session.h"
#include "viewer/view/view_choice.h"

namespace rocinante {
namespace {

using KnownModels = std::vector<const Model*>;

std::string hintAmong(std::vector<std::string_view> known, std::string_view name) {
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  return whatThereIs(name, known);
}

Error unknownName(const std::string& what, std::string_view name,
                  std::vector<std::string_view> known) {
  return {ErrorKind::not_found, what + ": " + hintAmong(std::move(known), name), {}};
}

void addModel(KnownModels& models, const Model* model) {
  if (std::ranges::find(models, model) == models.end()) models.push_back(model);
}

/// Groups of the parts that a link shows; empty when a mesh is missing and groups are unknown.
std::optional<std::vector<std::string_view>> groupsOf(const Link& link) {
  std::vector<std::string_view> groups;
  for (const Visual& visual : link.visuals) {
    if (visual.mesh == nullptr) return std::nullopt;
    const std::vector<MeshPart>& parts = visual.mesh->parts;
    for (const std::size_t part : visual.mesh_parts) groups.emplace_back(parts[part].group);
    if (!visual.mesh_parts.empty()) continue;
    for (const MeshPart& part : parts) groups.emplace_back(part.group);
  }
  return groups;
}

/// "`arm` has no link", "no device has a link".
std::string nobodyHas(const ViewPath& path, const std::string& what) {
  return path.all_devices ? "no device has a " + what : "`" + path.path.first + "` has no " + what;
}

}  // namespace

KnownNames::KnownNames(const Cell& cell) : cell_(cell), layers_(knownLayers(cell)) {
  for (const CellSource& source : cell.sources) {
    for (const auto& [ghost, original] : source.ghost_of) {
      const CellDevice* device = cell.findDevice(original);
      addModel(others_[ghost], device == nullptr ? nullptr : cell.modelOf(*device));
    }
    for (const std::string& device : source.devices) {
      if (others_.contains(device) || cell.findDevice(device) != nullptr) continue;
      others_[device] = allModels();
    }
  }
}

KnownNames::Models KnownNames::allModels() const {
  Models models;
  for (const CellDevice& device : cell_.devices) addModel(models, cell_.modelOf(device));
  for (const auto& [name, model] : cell_.models) addModel(models, model.get());
  return models;
}

std::optional<KnownNames::Models> KnownNames::modelsOf(const std::string& named) const {
  const bool is_beside = beside_is_shown_ && named.starts_with(kBesidePrefix);
  const std::string device = is_beside ? named.substr(kBesidePrefix.size()) : named;
  Models models;
  bool known = false;
  if (const CellDevice* of_cell = cell_.findDevice(device)) {
    known = true;
    addModel(models, cell_.modelOf(*of_cell));
  }
  if (const auto other = others_.find(device); other != others_.end()) {
    known = true;
    for (const Model* model : other->second) addModel(models, model);
  }
  if (const auto added = added_.find(device); added != added_.end()) {
    for (const std::string& name : added->second) {
      const auto model = cell_.models.find(name);
      if (model == cell_.models.end()) continue;  // then `add` has no effect
      known = true;
      addModel(models, model->second.get());
    }
  }
  if (others_may_come_) {
    // An `add` may also give a device of the cell a different model.
    for (const Model* model : allModels()) addModel(models, model);
    known = true;
  }
  return known ? std::optional(std::move(models)) : std::nullopt;
}

/// Where no cell is, whatever a packet names is a device.
void KnownNames::noteBare(std::string_view device) {
  if (cell_.bare_model.empty() || device.empty()) return;
  added_[std::string(device)].insert(cell_.bare_model);
}

Status KnownNames::readLog() {
  if (log_read_ || log_.empty()) return {};
  // The initial state of a cut or split log is in its first keyframe.
  auto session = Timeline::open(log_);
  if (!session) return session.error();
  // Ignored for names: drawing reports the damage of its state.
  StateDamage ignored;
  const auto first = session->stateAt(session->start(), &ignored);
  if (!first) return first.error();
  for (const auto& [device, state] : (*first)->devices()) {
    if (state.presence) added_[device].insert(state.presence->value.model);
    noteBare(device);
  }
  for (const auto& [name, view] : (*first)->views()) views_.insert(name);

  auto reader = LogReader::open(log_);
  if (!reader) return reader.error();
  MessageFolder folder;
  while (true) {
    const auto message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    const Packet* const packet = folder.decode(**message);
    if (packet == nullptr) continue;
    for (const Statement& statement : packet->statements) {
      if (isOfDevice(statement.kind)) noteBare(statement.name);
      if (isSignal(statement.kind)) noteBare(statement.path.first);
      if (statement.kind == StatementKind::add) {
        added_[std::string(statement.name)].emplace(statement.text);
      } else if (statement.kind == StatementKind::view) {
        views_.emplace(statement.name);
      }
    }
  }
  log_read_ = true;
  return {};
}

std::string KnownNames::deviceHint(const std::string& name) const {
  std::vector<std::string_view> known;
  for (const CellDevice& device : cell_.devices) known.emplace_back(device.name);
  for (const auto& [other, models] : others_) known.emplace_back(other);
  for (const auto& [device, models] : added_) known.emplace_back(device);
  return hintAmong(std::move(known), name);
}

Status KnownNames::checkLayer(const std::string& layer) const {
  if (layers_.contains(layer)) return {};
  return unknownName("unknown layer `" + layer + "`", layer, {layers_.begin(), layers_.end()});
}

/// Checks link and group of a PATH whose device can have any of these models.
Status KnownNames::checkBelow(const ViewPath& path, const Models& models) const {
  std::vector<std::string_view> links, groups;
  bool any_link = path.path.second.empty();
  for (const Model* model : models) {
    if (model == nullptr) return {};  // unreadable, which is reported elsewhere
    for (const Link& link : model->links) {
      links.emplace_back(link.name);
      if (!path.path.second.empty() && link.name != path.path.second) continue;
      any_link = true;
      if (!path.has_group) continue;
      const auto of_link = groupsOf(link);
      if (!of_link) return {};
      for (const std::string_view group : *of_link) {
        if (patternMatches(path.group, group)) return {};
        groups.push_back(group);
      }
    }
  }
  if (!any_link) {
    return unknownName(nobodyHas(path, "link `" + path.path.second + "`"), path.path.second,
                       std::move(links));
  }
  if (!path.has_group) return {};
  return unknownName(nobodyHas(path, "part in a group `" + path.group + "`"), path.group,
                     std::move(groups));
}

Status KnownNames::checkOne(const std::string& text) {
  const auto path = parseViewPath(text);
  if (!path) return {};
  if (path->path.is_layer) return checkLayer(path->path.second);
  if (path->all_devices) return checkBelow(*path, allModels());
  auto models = modelsOf(path->path.first);
  Status fit = models ? checkBelow(*path, *models) : Status{};
  if (models && fit) return {};
  if (!log_.empty() && !log_read_) {
    if (Status read = readLog(); !read) return read;
    return checkOne(text);
  }
  return models ? fit : checkDevice(path->path.first);
}

Status KnownNames::checkDevice(const std::string& device) {
  if (modelsOf(device)) return {};
  if (!log_.empty() && !log_read_) {
    if (Status read = readLog(); !read) return read;
    return checkDevice(device);
  }
  return Error{ErrorKind::not_found,
               std::string(log_.empty() ? "the cell has no device `"
                                        : "neither the cell nor the log has a device `") +
                   device + "`: " + deviceHint(device),
               {}};
}

Status KnownNames::check(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (sound_.contains(path)) continue;
    if (Status fit = checkOne(path); !fit) return fit;
    sound_.insert(path);
  }
  return {};
}

Status KnownNames::check(const RenderStyle& style) {
  for (const auto* paths : {&style.outlined, &style.wireframe, &style.collision,
                            &style.collision_over, &style.frames}) {
    if (Status fit = check(*paths); !fit) return fit;
  }
  for (const TransparentStyle& one : style.transparent) {
    if (Status fit = check({one.path}); !fit) return fit;
  }
  for (const TrailStyle& one : style.trails) {
    if (Status fit = check({one.path}); !fit) return fit;
  }
  for (const MeasureStyle& one : style.measures) {
    if (Status fit = check({one.from.path, one.to.path}); !fit) return fit;
  }
  return {};
}

Status KnownNames::checkCamera(const std::string& name) {
  if (others_may_come_ || name.starts_with('@') || cell_.findCamera(name) != nullptr) return {};
  if (Status read = readLog(); !read) return read;
  if (views_.contains(name)) return {};
  std::vector<std::string_view> known(views_.begin(), views_.end());
  for (const CellCamera& camera : cell_.cameras) known.emplace_back(camera.name);
  Error unknown = unknownName("unknown camera `" + name + "`", name, std::move(known));
  // A faulty camera is not in the cell.
  const auto fault = std::ranges::find_if(cell_.faults, [](const Finding& one) {
    return one.severity == Severity::error && one.rule.starts_with("cell.");
  });
  if (fault != cell_.faults.end()) {
    unknown.what += "; the cell has an error: " + cell_.shown(fault->print());
  }
  return unknown;
}

std::string KnownNames::doubtAbout(const std::string& text) const {
  const auto path = parseViewPath(text);
  if (!path || path->path.is_layer || path->all_devices || !others_may_come_) return {};
  const std::string& device = path->path.first;
  if (cell_.findDevice(device) != nullptr || others_.contains(device)) return {};
  return "the cell has no device `" + device +
         "`; the option takes effect once a source adds it; " + deviceHint(device);
}

}  // namespace rocinante
