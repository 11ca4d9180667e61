#include "core/kinematics/visual_materials.h"

#include <map>
#include <numeric>

namespace rocinante {
namespace {

const Material kPlain;

const Material& materialOf(const Mesh& mesh, std::size_t part) {
  const std::uint32_t number = mesh.parts[part].material;
  return number < mesh.materials.size() ? mesh.materials[number] : kPlain;
}

bool isOwn(const Material& material) {
  Material plain;
  plain.name = material.name;
  plain.missing_map = material.missing_map;
  return !material.name.empty() && material != plain;
}

}  // namespace

PartsByMaterial partsByMaterial(const Mesh& mesh) {
  PartsByMaterial parts;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    (isOwn(materialOf(mesh, i)) ? parts.own : parts.plain).push_back(i);
  }
  return parts;
}

std::vector<Visual> withChangedMaterials(const Visual& visual,
                                         const std::function<void(Material&)>& change) {
  std::vector<Visual> visuals;
  const auto add = [&](const Material& material) -> Visual& {
    Visual& made = visuals.emplace_back(visual);
    made.material = material;
    change(*made.material);
    return made;
  };
  if (visual.material || !visual.mesh) {
    add(visual.material.value_or(kPlain));
    return visuals;
  }
  const Mesh& mesh = *visual.mesh;
  std::vector<std::size_t> parts = visual.mesh_parts;
  if (parts.empty()) {
    parts.resize(mesh.parts.size());
    std::iota(parts.begin(), parts.end(), std::size_t{0});
  }
  std::map<std::uint32_t, std::vector<std::size_t>> by_material;
  for (const std::size_t part : parts) by_material[mesh.parts[part].material].push_back(part);
  for (auto& [number, those] : by_material) {
    Visual& made = add(materialOf(mesh, those.front()));
    if (by_material.size() > 1 || !visual.mesh_parts.empty()) made.mesh_parts = std::move(those);
  }
  return visuals;
}

}  // namespace rocinante
