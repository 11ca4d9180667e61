#include "core/mesh/mesh_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <mutex>

#include "core/document/fault_list.h"
#include "core/mesh/shapes.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxShapeSizes = 1000;  // 70 KB each at most

Mesh shapeMesh(const ShapeSize& shape) {
  const auto& [x, y, z] = shape.size;
  switch (shape.kind) {
    case ShapeSize::Kind::box:
      return boxMesh({x, y, z});
    case ShapeSize::Kind::sphere:
      return sphereMesh(x);
    case ShapeSize::Kind::cylinder:
      return cylinderMesh(x, z);
    case ShapeSize::Kind::capsule:
      return capsuleMesh(x, z);
  }
  return {};
}

}  // namespace

FoundFile MeshStore::find(const std::string& name, const std::filesystem::path& beside,
                          Severity severity, std::string_view rule, std::string_view kind,
                          Place place, FaultList& faults) const {
  FoundFile found = search_.find(name, beside);
  if (found.path.empty()) {
    std::string hint = found.hint();
    if (!hints_.insert(hint).second) hint.clear();
    faults.add(severity, rule, place,
               fmt::format("{} {} is not used: {}", kind, quotedPathInFault(name), found.problem()),
               std::move(hint));
  } else if (found.why == FoundFile::Why::found_elsewhere) {
    faults.warning("model.absolute-path", place,
                   fmt::format("{} {} is an absolute path of another machine; {} is taken", kind,
                               quotedPathInFault(name), quotedPathInFault(found.path.string())),
                   "name files relative to the model, or by package://");
  }
  return found;
}

void MeshStore::readWith(ParallelFor parallel, TellLoadProgress tell) {
  parallel_ = std::move(parallel);
  tell_ = std::move(tell);
}

MeshStore::Loaded MeshStore::read(const Key& key, const FoundFile& found) const {
  Loaded loaded;
  MeshReadOptions options;
  options.unit_m = std::get<1>(key);
  options.up = std::get<2>(key);
  options.resolve = [&](const std::string& wanted, const std::filesystem::path& folder) {
    loaded.lookups.push_back({folder, wanted, search_.look(wanted, folder, &found)});
    return loaded.lookups.back().found;
  };
  Result<Mesh> mesh = readMeshFile(std::get<0>(key), options, loaded.faults);
  if (mesh.ok()) {
    loaded.mesh = std::make_shared<const Mesh>(std::move(*mesh));
  } else {
    loaded.problem = mesh.error();
  }
  return loaded;
}

void MeshStore::readAhead(const std::vector<MeshWanted>& wanted) {
  if (!geometry_ || (!parallel_ && !tell_)) return;
  std::map<Key, Loaded> fresh;
  std::map<std::filesystem::path, FoundFile> found_by_path;
  for (const MeshWanted& mesh : wanted) {
    const FoundFile found = search_.look(mesh.name, mesh.beside);
    const Key key{found.path, mesh.unit_m, mesh.up};
    if (found.path.empty() || meshes_.contains(key)) continue;
    fresh.try_emplace(key);
    found_by_path.try_emplace(found.path, found);
  }
  if (fresh.empty()) return;
  // The largest first, so that no thread starts it last.
  struct Job {
    const Key* key;
    Loaded* loaded;
    std::uint64_t bytes;
  };
  std::vector<Job> jobs;
  for (auto& [key, loaded] : fresh) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(std::get<0>(key), error);
    jobs.push_back({&key, &loaded, error ? 0 : bytes});
    progress_.bytes_total += jobs.back().bytes;
  }
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const Job& a, const Job& b) { return a.bytes > b.bytes; });
  progress_.files_total += jobs.size();

  std::mutex telling;
  const auto readOne = [&](std::size_t i) {
    *jobs[i].loaded = read(*jobs[i].key, found_by_path.at(std::get<0>(*jobs[i].key)));
    const std::lock_guard lock(telling);
    ++progress_.files_done;
    progress_.bytes_done += jobs[i].bytes;
    if (tell_) tell_(progress_);
  };
  forEachIndex(parallel_, jobs.size(), readOne);
  meshes_.merge(fresh);
}

std::shared_ptr<const Mesh> MeshStore::load(const std::string& name,
                                            const std::filesystem::path& beside, double unit_m,
                                            UpAxis up, Place place, FaultList& faults) {
  const FoundFile found =
      find(name, beside, Severity::error, "model.missing-file", "the mesh", place, faults);
  if (found.path.empty() || !geometry_) return nullptr;
  const Key key{found.path, unit_m, up};
  auto entry = meshes_.find(key);
  if (entry == meshes_.end()) entry = meshes_.emplace(key, read(key, found)).first;
  Loaded& loaded = entry->second;
  if (!loaded.is_reported) {
    loaded.is_reported = true;
    addFile(found.path);
    for (const FileLookup& lookup : loaded.lookups) {
      search_.note(lookup);
      if (!lookup.found.path.empty()) addFile(lookup.found.path);
    }
    std::move(loaded.faults.begin(), loaded.faults.end(), std::back_inserter(faults.all()));
    loaded.lookups.clear();
    loaded.faults.clear();
  }
  if (!loaded.mesh) {
    // A mesh that is a model by itself is the finding's own place.
    const Error& problem = loaded.problem;
    const bool is_place = place.line == 0 && problem.where == faults.file();
    faults.error("model.unusable-mesh", place,
                 fmt::format("the mesh {} is not used: {}", quotedPathInFault(name),
                             is_place ? problem.what : problem.text()));
  }
  return loaded.mesh;
}

std::filesystem::path MeshStore::texture(const std::string& name,
                                         const std::filesystem::path& beside, Place place,
                                         FaultList& faults) {
  const std::filesystem::path path =
      find(name, beside, Severity::warning, "model.missing-texture", "the texture", place, faults)
          .path;
  if (!path.empty()) addFile(path);
  return path;
}

std::shared_ptr<const Mesh> MeshStore::shape(const ShapeSize& wanted, Vec3& scale, Place place,
                                             FaultList& faults) {
  if (!geometry_) return nullptr;
  ShapeSize made = wanted;
  if (!shapes_.contains(wanted) && shape_counts_[wanted.kind] >= kMaxShapeSizes) {
    if (wanted.kind == ShapeSize::Kind::capsule) {
      faults.error("model.unusable-mesh", place,
                   fmt::format("the capsule is not used: there are more than {} of other sizes",
                               kMaxShapeSizes),
                   "give them fewer sizes, or make each of a cylinder and two spheres");
      return nullptr;
    }
    // The first sizes keep their exact vertices: scaling would round differently.
    made.size = {1, 1, 1};
    scale = {wanted.size[0], wanted.size[1], wanted.size[2]};
  }
  std::shared_ptr<const Mesh>& mesh = shapes_[made];
  if (!mesh) {
    Mesh shaped = shapeMesh(made);
    shaped.shape = made;
    mesh = std::make_shared<const Mesh>(std::move(shaped));
    ++shape_counts_[made.kind];
  }
  return mesh;
}

}  // namespace rocinante
