#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "viewer/bake/bake_cell.h"
#include "viewer/detail/mesh_detail.h"
#include "viewer/page/page_parts.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Models as they are drawn, without the path of their file; shared ones stay shared.
class DrawnModels {
 public:
  explicit DrawnModels(int halvings) : halvings_(halvings) {}

  std::shared_ptr<const Model> of(const std::shared_ptr<const Model>& model) {
    if (!model) return nullptr;
    auto& made = made_[model];
    if (!made) {
      auto copy = std::make_shared<Model>(*model);
      copy->file = fs::path(copy->file).filename().string();
      for (Link& link : copy->links) {
        link.collisions.clear();
        for (Visual& visual : link.visuals) visual.mesh = thinned(visual.mesh);
      }
      made = std::move(copy);
    }
    return made;
  }

 private:
  std::shared_ptr<const Mesh> thinned(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh || halvings_ == 0) return mesh;
    auto& made = meshes_[mesh];
    if (!made) made = std::make_shared<const Mesh>(coarseMesh(*mesh, halvings_));
    return made;
  }

  int halvings_;
  std::map<std::shared_ptr<const Model>, std::shared_ptr<const Model>> made_;
  std::map<std::shared_ptr<const Mesh>, std::shared_ptr<const Mesh>> meshes_;
};

/// Names in the order in which paths are first asked for: "1/brick.png".
class PathNames {
 public:
  std::string of(const fs::path& path) {
    if (path.empty()) return {};
    const auto [known, is_new] = numbers_.try_emplace(path, numbers_.size() + 1);
    return std::to_string(known->second) + "/" + path.filename().string();
  }

 private:
  std::map<fs::path, std::size_t> numbers_;
};

}  // namespace

Bytes pageCell(const Cell& cell, const Thinness& thinness, const ParallelFor& parallel) {
  Cell drawn = cell;
  drawn.file = fs::path(cell.file).filename().string();
  drawn.faults.clear();
  drawn.files.clear();
  drawn.files_below.clear();
  drawn.files_shown_as.clear();
  drawn.rules.clear();
  drawn.clearances.clear();
  drawn.signals.clear();
  drawn.decoders.clear();
  DrawnModels models(thinness.halvings);
  for (auto& [name, model] : drawn.models) model = models.of(model);
  for (CellDevice& device : drawn.devices) device.dressed = models.of(device.dressed);
  PathNames names;
  BakeOptions options;
  options.compressed = true;
  options.largest_side = thinness.largest_side;
  options.parallel = parallel;
  options.path_text = [&](const fs::path& path) { return names.of(path); };
  return bakeCell(drawn, options);
}

}  // namespace rocinante
