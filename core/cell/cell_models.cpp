#include "core/cell/cell_models.h"

#include <fmt/format.h>

#include <set>

#include "core/base/name_hint.h"
#include "core/cell/inline_model.h"
#include "core/document/fault_list.h"
#include "core/kinematics/sdf_reader.h"
#include "core/kinematics/urdf_reader.h"

namespace rocinante {
namespace {

constexpr const char* kModelKinds[] = {"obj", "stl", "mesh", "urdf"};

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

std::shared_ptr<const Model> CellModels::readTreeFile(const std::string& name,
                                                      const std::filesystem::path& folder,
                                                      Place place, FaultList& faults) {
  const FoundFile found = meshes_.search().find(name, folder);
  if (found.path.empty()) {
    faults.error(
        "cell.missing-file", place,
        fmt::format("the model {} is not used: {}", quotedPathInFault(name), found.problem()),
        found.hint());
    return nullptr;
  }
  const auto known = files_.find(found.path);
  if (known != files_.end()) return known->second;
  std::shared_ptr<const Model> model;
  const bool is_sdf = endsIn(found.path.string(), ".sdf");
  const auto bytes = readWholeFile(found.path, is_sdf ? kMaxSdfBytes : kMaxUrdfBytes);
  if (!bytes.ok()) {
    faults.error(
        "cell.unusable-model", place,
        fmt::format("the model {} is not used: {}", quotedPathInFault(name), bytes.error().text()));
  } else {
    meshes_.addFile(found.path);
    const auto readTree = is_sdf ? readSdf : readUrdf;
    if (auto read = readTree(*bytes, found.path, meshes_, faults.all())) {
      model = std::make_shared<const Model>(std::move(*read));
    }
  }
  files_.emplace(found.path, model);
  return model;
}

std::shared_ptr<const Model> CellModels::readModelFile(const std::string& name,
                                                       const std::filesystem::path& folder,
                                                       Place place, FaultList& faults) {
  if (endsIn(name, ".urdf") || endsIn(name, ".sdf"))
    return readTreeFile(name, folder, place, faults);
  // A mesh that states its unit is a rigid model.
  auto mesh = meshes_.load(name, folder, 1.0, UpAxis::z, place, faults);
  const std::filesystem::path file(name);
  return std::make_shared<const Model>(rigidModel(file.stem().string(), name, std::move(mesh)));
}

void CellModels::readModel(TomlTable table, const std::filesystem::path& folder) {
  const auto name = names_.take(table);
  int kinds = 0;
  for (const char* key : kModelKinds) {
    kinds += table.has(key) ? 1 : 0;
    static_cast<void>(table.node(key));
  }
  if (kinds != 1) {
    table.faults().error("cell.model-kind", table.place(),
                         kinds == 0 ? "[[model]] names no file"
                                    : "[[model]] names more than one of obj, stl, mesh and urdf",
                         "give one of `obj`, `stl`, `mesh` and `urdf`");
    return;
  }
  std::shared_ptr<const Model> model;
  if (table.has("urdf")) {
    const auto file = table.requiredText("urdf");
    table.finish();
    if (file && name) model = readTreeFile(*file, folder, table.place("urdf"), table.faults());
  } else {
    model = readInlineModel(table, name.value_or("model"), folder, meshes_);
  }
  if (name) written_.emplace(*name, std::move(model));
}

std::string CellModels::use(const std::string& name, const TomlTable& table,
                            const std::filesystem::path& folder) {
  if (written_.contains(name)) return name;
  // As the cell itself would write it.
  std::string key = name;
  if (folder != main_folder_ && name.find(':') == std::string::npos) {
    key = (folder.lexically_relative(main_folder_) / name).lexically_normal().string();
  }
  if (used_.contains(key)) return key;
  if (endsIn(name, ".urdf") || endsIn(name, ".sdf") || (isMeshFile(name) && statesUnit(name))) {
    used_.emplace(key, readModelFile(name, folder, table.place("model"), table.faults()));
    return key;
  }
  std::vector<std::string_view> names;
  for (const auto& [known, model] : written_) names.push_back(known);
  std::string hint = didYouMean(name, names);
  if (isMeshFile(name)) {
    hint = "write a [[model]] with its name, unit and up axis, and use that";
  } else if (endsIn(name, ".xacro")) {
    hint = "expand the template first: xacro model.xacro > model.urdf";
  } else if (hint.empty()) {
    hint = "`model` is a .urdf, .sdf, .dae, .gltf or .glb file or the name of a [[model]]";
  }
  table.error("cell.unknown-model", "model",
              fmt::format("no model is named {}", quotedInFault(name)), std::move(hint));
  used_.emplace(key, nullptr);
  return key;
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
  // Later lines override: names that devices write, then names of [[model]]s.
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
