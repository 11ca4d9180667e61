#include "core/cell/cell_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/name_hint.h"
#include "core/cell/cell_layers.h"
#include "core/cell/rule_reader.h"
#include "core/document/fault_list.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

struct Target {
  std::string device, link;
};

// "arm" or "arm/link6": split at the first slash, since a device's name has none.
Target readTarget(TomlTable& table, std::string_view key) {
  const auto text = table.text(key);
  if (!text) return {};
  const std::size_t slash = std::min(text->find('/'), text->size());
  Target target{text->substr(0, slash), slash < text->size() ? text->substr(slash + 1) : ""};
  if (target.device.empty() || (slash < text->size() && target.link.empty())) {
    table.error("cell.bad-name", key,
                fmt::format("{} is neither DEVICE nor DEVICE/LINK", quotedInFault(*text)));
    return {};
  }
  return target;
}

// Clears a target that the cell does not have.
void checkTarget(const TomlTable& table, std::string_view key, const Cell& cell,
                 std::string& device_name, std::string& link_name) {
  if (device_name.empty()) return;
  const CellDevice* device = cell.findDevice(device_name);
  if (device == nullptr) {
    table.error("cell.unknown-device", key,
                fmt::format("`{}` of {} names {}, which is not a device of the cell", key,
                            table.what(), quotedInFault(device_name)),
                deviceHint(table, cell, device_name));
    device_name.clear();
    link_name.clear();
    return;
  }
  const Model* model = cell.modelOf(*device);
  if (link_name.empty() || model == nullptr || model->findLink(link_name)) return;
  std::vector<std::string_view> links;
  if (table.faults().lists("cell.unknown-link")) {
    for (const Link& link : model->links) links.push_back(link.name);
  }
  table.error(
      "cell.unknown-link", key,
      fmt::format("device {} has no link {}", quotedInFault(device_name), quotedInFault(link_name)),
      didYouMean(link_name, links));
  device_name.clear();
  link_name.clear();
}

// "arm" for "robots/arm.urdf"; for a [[model]] its name.
std::string nameFromModel(const std::string& model) {
  const std::size_t slash = model.find_last_of("/\\");
  const std::string file = slash == std::string::npos ? model : model.substr(slash + 1);
  const std::size_t dot = file.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

// Follows each chain of carriers once; one that comes back to itself is a loop.
void checkCarriers(const Cell& cell,
                   const std::vector<std::pair<TomlTable, std::string>>& carried) {
  std::map<std::string, std::size_t> turn;  // by device: the walk that passed it
  for (std::size_t first = 0; first < carried.size(); ++first) {
    const CellDevice* at = cell.findDevice(carried[first].second);
    while (at != nullptr && !at->on_device.empty() && turn.emplace(at->name, first).second) {
      at = cell.findDevice(at->on_device);
    }
    if (at == nullptr || at->on_device.empty() || turn.at(at->name) != first) continue;
    carried[first].first.error("cell.carrier-loop", "on",
                               fmt::format("device {} carries itself, directly or through others",
                                           quotedInFault(at->name)),
                               "all devices of the loop are placed in the world");
  }
}

bool runParallel(const Vec3& a, const Vec3& b) {
  const auto x = normalized(a), y = normalized(b);
  if (!x || !y) return true;
  const double along = x->x * y->x + x->y * y->y + x->z * y->z;
  return along * along > 1.0 - 1e-12;
}

void readGhost(const TomlTable& table, const TomlNode::Entry& ghost, const Cell& cell,
               CellSource& source) {
  if (ghost.value.kind != TomlNode::Kind::text) {
    table.faults().error("cell.wrong-kind", ghost.value.place,
                         fmt::format("{} of ghost_of is {}, where a device is expected",
                                     quotedInFault(ghost.key), nameOf(ghost.value.kind)));
  } else if (cell.findDevice(ghost.value.text) == nullptr) {
    table.faults().error("cell.unknown-device", ghost.value.place,
                         fmt::format("{} should be a ghost of {}, which is not a device of the "
                                     "cell",
                                     quotedInFault(ghost.key), quotedInFault(ghost.value.text)),
                         deviceHint(table, cell, ghost.value.text));
  } else {
    source.ghost_of.emplace(ghost.key, ghost.value.text);
  }
}

std::optional<CellCamera> readCamera(TomlTable& table, CellNames& names) {
  CellCamera camera;
  const auto name = names.take(table);
  const Target look = readTarget(table, "look_at");
  camera.look_device = look.device;
  camera.look_link = look.link;
  const auto eye = table.requiredVector("eye");
  const auto target = table.has("look_at") ? table.vector("target").value_or(Vec3{0, 0, 0})
                                           : table.requiredVector("target");
  const auto up = table.vector("up");
  if (const auto fov = table.number("fov_deg")) {
    if (*fov > 0.0 && *fov < 180.0) {
      camera.fov_deg = *fov;
    } else {
      table.error("cell.bad-number", "fov_deg", "`fov_deg` must be between 0 and 180");
    }
  }
  camera.ortho_height_m = table.positiveNumber("ortho_height_m");
  if (table.has("fov_deg") && table.has("ortho_height_m")) {
    table.error("cell.two-projections", "ortho_height_m",
                "the camera has both fov_deg and ortho_height_m");
  }
  readLens(table, camera);
  const Target on = readTarget(table, "on"), follow = readTarget(table, "follow");
  camera.on_device = on.device;
  camera.on_link = on.link;
  camera.follow_device = follow.device;
  camera.follow_link = follow.link;
  if (!on.device.empty() && !follow.device.empty()) {
    table.error("cell.on-and-follow", "follow",
                "a camera rides `on` a thing or follows one, not both");
    camera.follow_device.clear();
    camera.follow_link.clear();
  }
  table.finish();
  if (!name || !eye || !target) return std::nullopt;
  camera.name = *name;
  camera.eye = *eye;
  camera.target = *target;
  camera.up = up.value_or(Vec3{0, 0, 1});
  // With a look target the line of sight changes from moment to moment.
  if (table.has("look_at")) return camera;
  if (*eye == *target) {
    table.error("cell.no-direction", "target", "`eye` and `target` are the same point");
    return std::nullopt;
  }
  if (runParallel(camera.up, *target - *eye)) {
    if (up) {
      table.error("cell.no-direction", "up", "`up` points along the line of sight, or nowhere");
    }
    camera.up = runParallel({0, 0, 1}, *target - *eye) ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  }
  return camera;
}

}  // namespace

std::string deviceHint(const TomlTable& table, const Cell& cell, std::string_view name) {
  if (!table.faults().lists("cell.unknown-device")) return {};
  std::vector<std::string_view> names;
  for (const CellDevice& device : cell.devices) names.push_back(device.name);
  return didYouMean(name, names);
}

void DeviceReader::read(TomlTable& root, const std::filesystem::path& folder) {
  for (TomlTable& table : root.tables("device", "[[device]]")) {
    CellDevice device;
    // The only one of its kind needs no name.
    const auto model = table.requiredText("model");
    const auto name = table.has("name") ? names_.take(table)
                      : model           ? names_.take(table, nameFromModel(*model))
                                        : std::nullopt;
    static_cast<void>(table.node("name"));
    if (auto pose = table.table("pose", "pose")) {
      device.pose = pose->pose();
      pose->finish();
    }
    device.layer = table.text("layer").value_or("");
    checkLayer(table, "layer", cell_, device.layer);
    device.tags = table.texts("tags");
    for (const std::string& tag : device.tags) checkLayer(table, "tags", cell_, tag);
    device.optional = table.flag("optional").value_or(false);
    device.color = table.color("color");
    const Target on = readTarget(table, "on");
    device.on_device = on.device;
    device.on_link = on.link;
    table.finish();
    if (!name || !model) continue;
    device.name = *name;
    device.model = models_.use(*model, table, folder);
    if (!on.device.empty()) carried_.emplace_back(table, *name);
    cell_.device_by_name.emplace(*name, cell_.devices.size());
    cell_.devices.push_back(std::move(device));
  }
}

void DeviceReader::finish() {
  cell_.models = models_.named();
  for (const auto& [table, name] : carried_) {
    CellDevice& device = cell_.devices[cell_.device_by_name.at(name)];
    checkTarget(table, "on", cell_, device.on_device, device.on_link);
  }
  checkCarriers(cell_, carried_);
}

void readCameras(TomlTable& root, CellNames& names, Cell& cell) {
  for (TomlTable& table : root.tables("camera", "[[camera]]")) {
    auto camera = readCamera(table, names);
    if (!camera) continue;
    checkTarget(table, "on", cell, camera->on_device, camera->on_link);
    checkTarget(table, "follow", cell, camera->follow_device, camera->follow_link);
    checkTarget(table, "look_at", cell, camera->look_device, camera->look_link);
    cell.cameras.push_back(std::move(*camera));
  }
}

void readSources(TomlTable& root, CellNames& names, Cell& cell) {
  for (TomlTable& table : root.tables("source", "[[source]]")) {
    CellSource source;
    const auto name = names.take(table);
    source.rate_hz = table.range("rate_hz");
    if (source.rate_hz && source.rate_hz->first < 0.0) {
      table.error("cell.bad-range", "rate_hz", "`rate_hz` must not be below 0");
      source.rate_hz.reset();
    }
    source.limits = readSourceLimits(table);
    source.devices = table.texts("devices");
    if (table.table("ghost_of", "ghost_of")) {
      for (const TomlNode::Entry& entry : table.node("ghost_of")->entries) {
        readGhost(table, entry, cell, source);
      }
    }
    for (const std::string& device : source.devices) {
      if (cell.findDevice(device) != nullptr || source.ghost_of.contains(device)) continue;
      table.faults().warning("cell.unknown-device", table.place("devices"),
                             fmt::format("`devices` of [[source]] names {}, which the cell does "
                                         "not have",
                                         quotedInFault(device)),
                             deviceHint(table, cell, device));
    }
    table.finish();
    if (!name) continue;
    source.name = *name;
    cell.sources.push_back(std::move(source));
  }
}

void readScene(TomlTable& root, Cell& cell) {
  auto table = root.table("scene", "[scene]");
  if (!table) return;
  if (const auto top = table->color("background_top")) cell.scene.background_top = glm::vec3(*top);
  if (const auto bottom = table->color("background_bottom")) {
    cell.scene.background_bottom = glm::vec3(*bottom);
  }
  if (const auto light = table->vector("light")) {
    if (normalized(*light)) {
      cell.scene.light_direction = glm::vec3(*light);
    } else {
      table->error("cell.no-direction", "light", "`light` has no direction");
    }
    // Not for an included file: it cannot know of lights that replace its own.
    const bool knows = root.has("light") || table->faults().file() == cell.file;
    if (!cell.scene.lights.empty() && knows) {
      table->faults().warning("cell.useless-light", table->place("light"),
                              "`light` of [scene] has no effect: the cell has [[light]]s",
                              "the first [[light]] is the key light");
    }
  }
  cell.scene.grid = table->flag("grid").value_or(cell.scene.grid);
  struct Length {
    const char* key;
    double& value;
  };
  for (const Length& length : {Length{"grid_size_m", cell.scene.grid_size_m},
                               Length{"grid_step_m", cell.scene.grid_step_m}}) {
    if (const auto given = table->positiveNumber(length.key)) length.value = *given;
  }
  if (cell.scene.grid_size_m > 1000.0 * cell.scene.grid_step_m) {
    table->error("cell.bad-number", "grid_step_m",
                 "the grid has more than 1,000 lines to each side", "the step is enlarged");
    cell.scene.grid_step_m = cell.scene.grid_size_m / 1000.0;
  }
  table->finish();
}

}  // namespace rocinante
