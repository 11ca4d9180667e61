#include <fmt/format.h>

#include <set>

#include "core/model/cell_reader.h"
#include "core/model/fault_list.h"
#include "core/model/inline_model.h"
#include "core/model/name_hint.h"
#include "core/model/urdf_reader.h"

namespace rocinante {
namespace {

bool endsIn(const std::string& name, std::string_view ending) {
  if (name.size() < ending.size()) return false;
  for (std::size_t i = 0; i < ending.size(); ++i) {
    const char c = name[name.size() - ending.size() + i];
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower != ending[i]) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const Model> CellModels::readUrdfFile(const std::string& name, Place place,
                                                      FaultList& faults) {
  const FoundFile found = meshes_.search().find(name, folder_);
  if (found.path.empty()) {
    faults.error("cell.missing-file", place,
                 fmt::format("the model {} is not used: {}", quotedInFault(name), found.problem()),
                 found.hint());
    return nullptr;
  }
  const auto known = files_.find(found.path);
  if (known != files_.end()) return known->second;
  std::shared_ptr<const Model> model;
  const auto bytes = readWholeFile(found.path, kMostUrdfBytes);
  if (!bytes.ok()) {
    faults.error(
        "cell.unusable-model", place,
        fmt::format("the model {} is not used: {}", quotedInFault(name), bytes.error().text()));
  } else {
    meshes_.addFile(found.path);
    if (auto read = readUrdf(*bytes, found.path, meshes_, faults.all())) {
      model = std::make_shared<const Model>(std::move(*read));
    }
  }
  files_.emplace(found.path, model);
  return model;
}

void CellModels::readModel(TomlTable table) {
  const auto name = table.requiredName("name");
  const int kinds = int{table.has("obj")} + int{table.has("stl")} + int{table.has("urdf")};
  if (kinds != 1) {
    for (const char* key : {"obj", "stl", "urdf"}) static_cast<void>(table.node(key));
    table.faults().error("cell.model-kind", table.place(),
                         kinds == 0 ? "[[model]] names no file"
                                    : "[[model]] names more than one of obj, stl and urdf",
                         "give one of `obj`, `stl` and `urdf`");
    return;
  }
  std::shared_ptr<const Model> model;
  if (table.has("urdf")) {
    const auto file = table.requiredText("urdf");
    table.finish();
    if (file) model = readUrdfFile(*file, table.place("urdf"), table.faults());
  } else {
    model = readInlineModel(table, name.value_or("model"), folder_, meshes_);
  }
  if (!name) return;
  if (written_.contains(*name)) {
    table.error("cell.duplicate-name", "name",
                fmt::format("a second [[model]] is named {}", quotedInFault(*name)),
                "the first one stands");
    return;
  }
  written_.emplace(*name, std::move(model));
}

void CellModels::use(const std::string& name, const TomlTable& table) {
  if (written_.contains(name) || used_.contains(name)) return;
  if (endsIn(name, ".urdf")) {
    used_.emplace(name, readUrdfFile(name, table.place("model"), table.faults()));
    return;
  }
  std::vector<std::string_view> names;
  for (const auto& [known, model] : written_) names.push_back(known);
  std::string hint = didYouMean(name, names);
  if (endsIn(name, ".obj") || endsIn(name, ".stl")) {
    hint = "write a [[model]] with its name, unit and up axis, and use that";
  } else if (endsIn(name, ".xacro")) {
    hint = "expand the template first: xacro model.xacro > model.urdf";
  } else if (hint.empty()) {
    hint = "`model` is a .urdf file or the name of a [[model]]";
  }
  table.error("cell.unknown-model", "model", fmt::format("no model is {}", quotedInFault(name)),
              std::move(hint));
  used_.emplace(name, nullptr);
}

std::map<std::string, std::shared_ptr<const Model>> CellModels::named() const {
  std::map<std::string, std::shared_ptr<const Model>> names;
  std::set<std::string> ambiguous;
  for (const auto& [name, model] : used_) {
    if (!model) continue;
    const std::string file = std::filesystem::path(model->file).filename().string();
    for (const std::string& shorter : {file, std::filesystem::path(file).stem().string()}) {
      const auto [known, is_new] = names.emplace(shorter, model);
      if (!is_new && known->second != model) ambiguous.insert(shorter);
    }
  }
  for (const std::string& name : ambiguous) names.erase(name);
  // Later lines outrank: what a device writes, then what a [[model]] is called.
  for (const auto& [name, model] : used_) {
    if (model) names[name] = model;
  }
  for (const auto& [name, model] : written_) {
    names.erase(name);
    if (model) names.emplace(name, model);
  }
  return names;
}

}  // namespace rocinante
