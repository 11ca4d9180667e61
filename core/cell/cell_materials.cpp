#include "core/cell/cell_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/pattern.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

// Devices and changes compared, of one cell.
constexpr std::size_t kMaxComparisons = 100'000'000;

bool isLike(const std::string& pattern, std::string_view name) {
  return pattern.empty() || patternMatches(pattern, name);
}

/// One of `words`, as the value at its place; a fault for others.
template <class Value, std::size_t N>
std::optional<Value> readWord(TomlTable& table, std::string_view key,
                              const std::array<std::pair<std::string_view, Value>, N>& words) {
  const auto text = table.text(key);
  if (!text) return std::nullopt;
  std::string known;
  for (const auto& [word, value] : words) {
    if (*text == word) return value;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
  }
  table.error("cell.unknown-word", key,
              fmt::format("{} is not one of {}", quotedInFault(*text), known));
  return std::nullopt;
}

constexpr auto kAlphaWords = std::to_array<std::pair<std::string_view, AlphaMode>>(
    {{"blend", AlphaMode::blend}, {"opaque", AlphaMode::opaque}, {"mask", AlphaMode::mask}});
constexpr auto kWrapWords = std::to_array<std::pair<std::string_view, TextureWrap>>(
    {{"repeat", TextureWrap::repeat},
     {"mirror", TextureWrap::mirrored_repeat},
     {"clamp", TextureWrap::clamp_to_edge}});

std::optional<glm::vec2> readPair(TomlTable& table, std::string_view key) {
  const auto pair = table.pair(key);
  if (!pair) return std::nullopt;
  return glm::vec2(static_cast<float>(pair->x), static_cast<float>(pair->y));
}

void change(const MaterialChange& by, Material& material) {
  if (by.color) {
    material.diffuse = *by.color;
    material.alpha_mode = AlphaMode::blend;
    // As everywhere, a colour replaces the texture.
    if (!by.texture) {
      material.diffuse_map.clear();
      material.diffuse_bytes.reset();
      material.missing_map.clear();
    }
  }
  if (by.texture) {
    material.diffuse_map = *by.texture;
    material.diffuse_bytes.reset();
    material.missing_map.clear();
    // Without a colour of its own, the texture is drawn unmodified.
    if (!by.color && !by.texture->empty()) {
      material.diffuse = glm::vec4(1.0F, 1.0F, 1.0F, material.diffuse.a);
    }
  }
  material.specular = by.specular.value_or(material.specular);
  material.emission = by.emission.value_or(material.emission);
  material.shininess = by.shininess.value_or(material.shininess);
  material.map_scale = by.texture_scale.value_or(material.map_scale);
  material.map_offset = by.texture_offset.value_or(material.map_offset);
  material.map_rotation = by.texture_rotation.value_or(material.map_rotation);
  material.wrap_u = by.texture_wrap.value_or(material.wrap_u);
  material.wrap_v = by.texture_wrap.value_or(material.wrap_v);
  material.alpha_mode = by.alpha.value_or(material.alpha_mode);
  material.alpha_cutoff = by.alpha_cutoff.value_or(material.alpha_cutoff);
}

std::optional<glm::vec3> readColor(TomlTable& table, std::string_view key) {
  const auto color = table.color(key);
  if (!color) return std::nullopt;
  return glm::vec3(*color);
}

// The visual as several: parts that look alike together, unchanged ones first.
struct DressedVisual {
  Visual unchanged;
  std::vector<Visual> changed;

  explicit DressedVisual(const Visual& visual) : unchanged(visual) { unchanged.mesh_parts.clear(); }
  void add(std::size_t part, const Material& material) {
    auto found = std::ranges::find_if(
        changed, [&](const Visual& visual) { return *visual.material == material; });
    if (found == changed.end()) {
      changed.push_back(unchanged);
      found = std::prev(changed.end());
      found->mesh_parts.clear();
      found->material = material;
    }
    found->mesh_parts.push_back(part);
  }
};

}  // namespace

void CellMaterials::read(TomlTable& root, const std::filesystem::path& folder, MeshStore& meshes) {
  for (TomlTable& table : root.tables("material", "[[material]]")) {
    MaterialChange what;
    what.device = table.text("device").value_or("");
    what.link = table.text("link").value_or("");
    what.group = table.text("group").value_or("");
    what.material = table.text("material").value_or("");
    what.color = table.color("color");
    what.specular = readColor(table, "specular");
    what.emission = readColor(table, "emission");
    if (const auto shininess = table.number("shininess")) {
      if (*shininess >= 0.0 && *shininess <= 1000.0) {
        what.shininess = static_cast<float>(*shininess);
      } else {
        table.error("cell.bad-number", "shininess", "`shininess` is between 0 and 1000");
      }
    }
    if (const auto texture = table.text("texture")) {
      what.texture.emplace();
      if (!texture->empty()) {
        *what.texture = meshes.texture(*texture, folder, table.place("texture"), table.faults());
        if (what.texture->empty()) what.texture.reset();
      }
    }
    what.texture_scale = readPair(table, "texture_scale");
    what.texture_offset = readPair(table, "texture_offset");
    if (const auto degrees = table.number("texture_rotation_deg")) {
      what.texture_rotation = static_cast<float>(radiansOf(*degrees));
    }
    what.texture_wrap = readWord(table, "texture_wrap", kWrapWords);
    what.alpha = readWord(table, "alpha", kAlphaWords);
    if (const auto cutoff = table.number("alpha_cutoff")) {
      if (*cutoff >= 0.0 && *cutoff <= 1.0) {
        what.alpha_cutoff = static_cast<float>(*cutoff);
      } else {
        table.error("cell.bad-number", "alpha_cutoff", "`alpha_cutoff` is between 0 and 1");
      }
    }
    table.finish();
    const bool is_stated = table.has("color") || table.has("specular") || table.has("emission") ||
                           table.has("shininess") || table.has("texture") ||
                           table.has("texture_scale") || table.has("texture_offset") ||
                           table.has("texture_rotation_deg") || table.has("texture_wrap") ||
                           table.has("alpha") || table.has("alpha_cutoff");
    if (!is_stated) {
      table.faults().error("cell.missing-key", table.place(), "[[material]] changes nothing",
                           "give it a color, texture, specular, emission or shininess");
    }
    changes_.push_back({std::move(what), table, false});
  }
}

void CellMaterials::apply(Cell& cell) {
  if (changes_.empty()) return;
  if (changes_.size() * cell.devices.size() > kMaxComparisons) {
    changes_.back().table.faults().error(
        "cell.too-many", changes_.back().table.place(),
        fmt::format("{} devices and {} materials are too many to compare", cell.devices.size(),
                    changes_.size()));
    return;
  }
  Chosen of_all;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (changes_[i].what.device.empty()) of_all.push_back(i);
  }
  std::map<std::pair<const Model*, Chosen>, std::shared_ptr<const Model>> made;
  const auto dress = [&](const std::shared_ptr<const Model>& model, const Chosen& chosen) {
    auto& known = made[{model.get(), chosen}];
    if (!known) known = dressed(*model, chosen);
    return known;
  };
  for (CellDevice& device : cell.devices) {
    const auto model = cell.models.find(device.model);
    if (model == cell.models.end() || !model->second) continue;
    Chosen chosen;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      if (isLike(changes_[i].what.device, device.name)) chosen.push_back(i);
    }
    if (chosen.size() > of_all.size()) device.dressed = dress(model->second, chosen);
  }
  if (!of_all.empty()) {
    // Last: until here devices were dressed from the models as read.
    for (auto& [name, model] : cell.models) {
      if (model) model = dress(model, of_all);
    }
  }
  for (const Change& change : changes_) {
    if (change.used) continue;
    change.table.faults().warning("cell.unused-material", change.table.place(),
                                  "this [[material]] matches nothing in the cell",
                                  "`device`, `link`, `group` and `material` must all match");
  }
}

bool CellMaterials::matches(const Change& change, const Link& link, const MeshPart& part,
                            const Material& material) const {
  return isLike(change.what.link, link.name) && isLike(change.what.group, part.group) &&
         isLike(change.what.material, material.name);
}

std::shared_ptr<const Model> CellMaterials::dressed(const Model& model, const Chosen& chosen) {
  auto copy = std::make_shared<Model>(model);
  for (Link& link : copy->links) {
    std::vector<Visual> visuals;
    for (const Visual& visual : link.visuals) {
      if (!visual.mesh) {
        visuals.push_back(visual);
        continue;
      }
      const Mesh& mesh = *visual.mesh;
      DressedVisual made(visual);
      const auto look_at = [&](std::size_t number) {
        const MeshPart& part = mesh.parts[number];
        const Material own = visual.material                         ? *visual.material
                             : part.material < mesh.materials.size() ? mesh.materials[part.material]
                                                                     : Material{};
        Material material = own;
        bool any = false;
        for (const std::size_t i : chosen) {
          if (!matches(changes_[i], link, part, own)) continue;
          change(changes_[i].what, material);
          changes_[i].used = any = true;
        }
        if (any) {
          made.add(number, material);
        } else {
          made.unchanged.mesh_parts.push_back(number);
        }
      };
      if (visual.mesh_parts.empty()) {
        for (std::size_t part = 0; part < mesh.parts.size(); ++part) look_at(part);
      }
      for (const std::size_t part : visual.mesh_parts) look_at(part);
      if (made.changed.empty()) {
        visuals.push_back(visual);
        continue;
      }
      if (!made.unchanged.mesh_parts.empty()) visuals.push_back(std::move(made.unchanged));
      for (Visual& changed : made.changed) visuals.push_back(std::move(changed));
    }
    link.visuals = std::move(visuals);
  }
  return copy;
}

}  // namespace rocinante
