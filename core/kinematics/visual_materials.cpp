#include "core/kinematics/visual_materials.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace rocinante {
namespace {

struct Named {
  std::string_view name;
  float r, g, b;
  float opacity = 1;
  bool glows = false;
};

constexpr auto kColors = std::to_array<Named>({
    {"Black", 0, 0, 0},
    {"Blue", 0, 0, 1},
    {"BlueGlow", 0, 0, 1, 1, true},
    {"BlueLaser", 0, 0, 1, 0.4F},
    {"BlueTransparent", 0, 0, 1, 0.5F},
    {"BlueTransparentOverlay", 0, 0, 1, 0.5F},
    {"DarkGrey", 0.175F, 0.175F, 0.175F},
    {"DarkMagentaTransparent", 0.6F, 0, 0.6F, 0.5F},
    {"DarkOrangeTransparentOverlay", 0.6F, 0.305F, 0.028F, 0.8F},
    {"DarkYellow", 0.7F, 0.7F, 0},
    {"FlatBlack", 0.1F, 0.1F, 0.1F},
    {"Gold", 0.8F, 0.64869F, 0.120759F},
    {"Green", 0, 1, 0},
    {"GreenGlow", 0, 1, 0, 1, true},
    {"GreenTransparent", 0, 1, 0, 0.5F},
    {"GreenTransparentOverlay", 0, 1, 0, 0.5F},
    {"Grey", 0.7F, 0.7F, 0.7F},
    {"GreyTransparent", 0.5F, 0.5F, 0.5F, 0.5F},
    {"Indigo", 0.33F, 0, 0.5F},
    {"LightBlueLaser", 0.5F, 0.5F, 1, 0.4F},
    {"LightOff", 1, 0, 0, 1, true},
    {"LightOn", 0, 1, 0, 1, true},
    {"Orange", 1, 0.5088F, 0.0468F},
    {"OrangeTransparent", 1, 0.44F, 0, 0.4F},
    {"OrangeTransparentOverlay", 1, 0.5088F, 0.0468F, 0.8F},
    {"Purple", 1, 0, 1},
    {"PurpleGlow", 1, 0, 1, 1, true},
    {"Red", 1, 0, 0},
    {"RedBright", 0.87F, 0.26F, 0.07F},
    {"RedGlow", 1, 0, 0, 1, true},
    {"RedTransparent", 1, 0, 0, 0.5F},
    {"RedTransparentOverlay", 1, 0, 0, 0.5F},
    {"SkyBlue", 0.13F, 0.44F, 0.7F},  // its ambient: by its diffuse it would be Blue
    {"Turquoise", 0, 1, 1},
    {"TurquoiseGlow", 0, 1, 1, 1, true},
    {"White", 1, 1, 1},
    {"WhiteGlow", 1, 1, 1, 1, true},
    {"Yellow", 1, 1, 0},
    {"YellowGlow", 1, 1, 0, 1, true},
    {"YellowTransparent", 1, 1, 0, 0.5F},
    {"ZincYellow", 0.9725F, 0.9529F, 0.2078F},
});
static_assert(std::ranges::is_sorted(kColors, {}, &Named::name));

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

std::optional<GazeboColor> gazeboColor(std::string_view script) {
  constexpr std::string_view kCollection = "Gazebo/";
  if (!script.starts_with(kCollection)) return std::nullopt;
  script.remove_prefix(kCollection.size());
  const auto* const found = std::ranges::lower_bound(kColors, script, {}, &Named::name);
  if (found == kColors.end() || found->name != script) return std::nullopt;
  GazeboColor color{{found->r, found->g, found->b, found->opacity}};
  if (found->glows) color.emission = {found->r, found->g, found->b};
  return color;
}

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
