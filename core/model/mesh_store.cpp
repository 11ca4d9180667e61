#include "core/model/mesh_store.h"

#include <fmt/format.h>

#include "core/model/fault_list.h"

namespace rocinante {

std::filesystem::path MeshStore::find(const std::string& name, const std::filesystem::path& beside,
                                      Severity severity, std::string_view rule,
                                      std::string_view kind, Place place, FaultList& faults) const {
  const FoundFile found = search_.find(name, beside);
  if (found.path.empty()) {
    faults.add(severity, rule, place,
               fmt::format("{} {} is not used: {}", kind, quotedInFault(name), found.problem()),
               found.hint());
  } else if (found.why == FoundFile::Why::found_elsewhere) {
    faults.warning("model.absolute-path", place,
                   fmt::format("{} {} is an absolute path of another machine; {} is taken", kind,
                               quotedInFault(name), quotedInFault(found.path.string())),
                   "name files relative to the model, or by package://");
  }
  return found.path;
}

std::shared_ptr<const Mesh> MeshStore::load(const std::string& name,
                                            const std::filesystem::path& beside, double unit_m,
                                            UpAxis up, Place place, FaultList& faults) {
  const std::filesystem::path path =
      find(name, beside, Severity::error, "model.missing-file", "the mesh", place, faults);
  if (path.empty() || !geometry_) return nullptr;
  const auto [entry, is_new] = meshes_.try_emplace({path, unit_m, up});
  Loaded& loaded = entry->second;
  if (is_new) {
    addFile(path);
    MeshReadOptions options;
    options.unit_m = unit_m;
    options.up = up;
    options.resolve = [this](const std::string& wanted, const std::filesystem::path& folder) {
      const FoundFile found = search_.find(wanted, folder);
      if (!found.path.empty()) addFile(found.path);
      return found.path;
    };
    Result<Mesh> mesh = readMeshFile(path, options, faults.all());
    if (mesh.ok()) {
      loaded.mesh = std::make_shared<const Mesh>(std::move(*mesh));
    } else {
      loaded.problem = mesh.error().text();
    }
  }
  if (!loaded.mesh) {
    faults.error("model.unusable-mesh", place,
                 fmt::format("the mesh {} is not used: {}", quotedInFault(name), loaded.problem));
  }
  return loaded.mesh;
}

std::filesystem::path MeshStore::texture(const std::string& name,
                                         const std::filesystem::path& beside, Place place,
                                         FaultList& faults) {
  const std::filesystem::path path =
      find(name, beside, Severity::warning, "model.missing-texture", "the texture", place, faults);
  if (!path.empty()) addFile(path);
  return path;
}

std::shared_ptr<const Mesh> MeshStore::shape(const std::string& key,
                                             const std::function<Mesh()>& make) {
  if (!geometry_) return nullptr;
  std::shared_ptr<const Mesh>& mesh = shapes_[key];
  if (!mesh) mesh = std::make_shared<const Mesh>(make());
  return mesh;
}

}  // namespace rocinante
