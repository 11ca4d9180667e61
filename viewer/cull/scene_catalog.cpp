#include "viewer/cull/scene_catalog.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/transform.h"
#include "viewer/cull/coplanar_surfaces.h"

namespace rocinante {
namespace {

/// By part of each mesh: the number of the link that it moves with.
std::map<const Mesh*, std::vector<std::uint32_t>> bodiesOf(const Model& model,
                                                           DrawnGeometry geometry) {
  std::map<const Mesh*, std::vector<std::uint32_t>> bodies;
  std::uint32_t number = 0;
  for (const Link& link : model.links) {
    const auto& drawn = geometry == DrawnGeometry::visuals ? link.visuals : link.collisions;
    for (const Visual& visual : drawn) {
      if (!visual.mesh || visual.mesh_parts.empty()) continue;
      std::vector<std::uint32_t>& of_mesh = bodies[visual.mesh.get()];
      of_mesh.resize(visual.mesh->parts.size());
      for (const std::size_t part : visual.mesh_parts) {
        if (part < of_mesh.size()) of_mesh[part] = number;
      }
    }
    ++number;
  }
  return bodies;
}

/// Returns how many of the part's indices were moved to its end.
std::uint32_t putOneSidedLast(const MeshPart& part, const std::vector<std::uint8_t>& one_sided,
                              std::vector<std::uint32_t>& indices) {
  std::vector<std::uint32_t> last;
  std::uint32_t to = part.first_index;
  for (std::uint32_t from = part.first_index; from < part.first_index + part.index_count;
       from += 3) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t index = indices[from + corner];
      if (one_sided[from / 3] != 0) {
        last.push_back(index);
      } else {
        indices[to++] = index;
      }
    }
  }
  for (const std::uint32_t index : last) indices[to++] = index;
  return static_cast<std::uint32_t>(last.size());
}

}  // namespace

SceneCatalog::SceneCatalog(const Cell& cell, DrawnGeometry geometry) : at_hand_(&cell.pictures) {
  for (const auto& [name, model] : cell.models) {
    if (model) addModel(*model, geometry);
  }
  std::set<const Model*> dressed;  // thousands of devices may share one
  for (const CellDevice& device : cell.devices) {
    if (device.dressed && dressed.insert(device.dressed.get()).second)
      addModel(*device.dressed, geometry);
  }
  at_hand_ = nullptr;
}

void SceneCatalog::addModel(const Model& model, DrawnGeometry geometry) {
  std::map<const Mesh*, std::vector<std::uint32_t>> bodies = bodiesOf(model, geometry);
  LinkReaches& reaches = reaches_[&model];
  reaches.clear();
  for (const Link& link : model.links) {
    double& reach = reaches.emplace_back(-1);
    const auto& drawn = geometry == DrawnGeometry::visuals ? link.visuals : link.collisions;
    for (const Visual& visual : drawn) {
      if (visual.material) addTexture(*visual.material);
      if (!visual.mesh) continue;
      addMesh(visual.mesh.get(), bodies[visual.mesh.get()]);
      const CatalogMesh& mesh = meshes_[*meshNumber(visual.mesh.get())];
      const Mat4 in_link = matrixOf(visual.origin) * scaleMatrix(visual.scale);
      for (const CatalogPart& part : mesh.parts) {
        const double size = scaleBound(in_link) * (lengthOf(part.center) + part.radius);
        const double farthest = lengthOf(Vec3(in_link[3])) + size;
        // NaN makes the reach infinite.
        reach = std::isfinite(farthest) ? std::max(reach, farthest) : HUGE_VAL;
      }
    }
  }
}

SceneCatalog::TextureUse SceneCatalog::useOf(const Material& material) {
  return {material.diffuse_map, material.alpha_mode == AlphaMode::opaque, material.wrap_u,
          material.wrap_v};
}

void SceneCatalog::addTexture(const Material& material) {
  if (material.diffuse_map.empty()) return;
  has_cutouts_ = has_cutouts_ || material.alpha_mode == AlphaMode::mask;
  const auto number = static_cast<std::uint32_t>(textures_.size());
  if (texture_numbers_.emplace(useOf(material), number).second) {
    const auto at_hand = at_hand_->find(material.diffuse_map);
    textures_.push_back({material.diffuse_map, material.diffuse_bytes,
                         at_hand == at_hand_->end() ? ByteView() : at_hand->second,
                         material.alpha_mode == AlphaMode::opaque, material.wrap_u,
                         material.wrap_v});
  }
}

void SceneCatalog::addMesh(const Mesh* mesh, const std::vector<std::uint32_t>& bodies) {
  const auto number = static_cast<std::uint32_t>(meshes_.size());
  if (!mesh_numbers_.emplace(mesh, number).second) return;
  for (const Material& material : mesh->materials) addTexture(material);

  CatalogMesh entry{mesh, {}, {}};
  const CoplanarSurfaces surfaces = coplanarSurfaces(*mesh, bodies);
  if (surfaces.any_one_sided) entry.reordered = mesh->indices;
  for (std::size_t i = 0; i < mesh->parts.size(); ++i) {
    const MeshPart& part = mesh->parts[i];
    Bounds bounds;
    for (std::uint32_t index = 0; index < part.index_count; ++index) {
      bounds.add(Vec3(mesh->vertices[mesh->indices[part.first_index + index]].position));
    }
    CatalogPart known;
    known.coplanar_rank = surfaces.ranks[i];
    known.faces = flatFaces(*mesh, part);
    if (surfaces.any_one_sided) {
      known.one_sided_count = putOneSidedLast(part, surfaces.one_sided, entry.reordered);
    }
    if (!bounds.empty()) {
      known.center = (bounds.min + bounds.max) * 0.5;
      known.half = (bounds.max - bounds.min) * 0.5;
      known.radius = std::sqrt(known.half.x * known.half.x + known.half.y * known.half.y +
                               known.half.z * known.half.z);
    }
    entry.parts.push_back(known);
  }
  meshes_.push_back(std::move(entry));
}

std::vector<DetailInput> SceneCatalog::detailInputs() const {
  std::vector<DetailInput> inputs;
  for (const CatalogMesh& mesh : meshes_) {
    DetailInput input{mesh.mesh, &mesh.indices(), {}};
    for (const CatalogPart& part : mesh.parts) {
      input.one_sided_counts.push_back(part.one_sided_count);
    }
    inputs.push_back(std::move(input));
  }
  return inputs;
}

void SceneCatalog::setDetail(std::size_t mesh_number, const MeshDetail& detail) {
  CatalogMesh& mesh = meshes_[mesh_number];
  const auto own = static_cast<std::uint32_t>(mesh.indices().size());
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    mesh.parts[i].coarser = detail.parts[i];
    for (CoarsePart& part : mesh.parts[i].coarser) part.first_index += own;
  }
}

std::optional<std::uint32_t> SceneCatalog::meshNumber(const Mesh* mesh) const {
  const auto found = mesh_numbers_.find(mesh);
  if (found == mesh_numbers_.end()) return std::nullopt;
  return found->second;
}

const LinkReaches* SceneCatalog::reaches(const Model& model) const {
  const auto found = reaches_.find(&model);
  return found == reaches_.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> SceneCatalog::textureNumber(const Material& material) const {
  const auto found = texture_numbers_.find(useOf(material));
  if (found == texture_numbers_.end()) return std::nullopt;
  return found->second;
}

}  // namespace rocinante
