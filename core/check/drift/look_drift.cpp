#include "core/check/drift/look_drift.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/check/drift/joint_drift.h"

namespace rocinante {
namespace {

/// Indices of the mesh parts that a visual draws.
std::vector<std::size_t> partsOf(const Visual& visual) {
  if (!visual.mesh_parts.empty() || visual.mesh == nullptr) return visual.mesh_parts;
  std::vector<std::size_t> all(visual.mesh->parts.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

std::size_t trianglesOf(const Visual& visual) {
  std::size_t corners = 0;
  for (const std::size_t part : partsOf(visual)) corners += visual.mesh->parts[part].index_count;
  return corners / 3;
}

/// The sides of the box around what it draws, by its scale; zeros when it draws nothing.
Vec3 sizeOf(const Visual& visual) {
  Bounds bounds;
  for (const std::size_t part : partsOf(visual)) {
    const MeshPart& run = visual.mesh->parts[part];
    for (std::size_t i = 0; i < run.index_count; ++i) {
      bounds.add(Vec3(visual.mesh->vertices[visual.mesh->indices[run.first_index + i]].position));
    }
  }
  if (bounds.empty()) return Vec3(0, 0, 0);
  return glm::abs((bounds.max - bounds.min) * visual.scale);
}

/// "200 x 200 x 500 mm".
std::string sidesText(const Vec3& size) {
  const bool is_large = std::max({size.x, size.y, size.z}) >= 10;
  const Vec3 shown = is_large ? size : size * 1000.0;
  return fmt::format("{:.4g} x {:.4g} x {:.4g} {}", shown.x, shown.y, shown.z,
                     is_large ? "m" : "mm");
}

/// "25.4 times as large", or both sizes when only some sides differ; empty when they are the same.
std::string sizeText(const Visual& was, const Visual& is) {
  const Vec3 before = sizeOf(was), after = sizeOf(is);
  const double longest_before = std::max({before.x, before.y, before.z});
  const double longest = std::max({after.x, after.y, after.z});
  if (longest_before <= 0 || longest <= 0) return "";
  const Vec3 off = glm::abs(after - before);
  if (std::max({off.x, off.y, off.z}) < 1e-4 * longest_before) return "";
  const double ratio = longest / longest_before;
  const Vec3 rest = glm::abs(after - before * ratio);
  const bool is_whole = std::max({rest.x, rest.y, rest.z}) < 1e-3 * longest;
  if (!is_whole || std::abs(ratio - 1) < 0.01) {
    return fmt::format("was {}, now {}", sidesText(before), sidesText(after));
  }
  return ratio > 1 ? fmt::format("{:.4g} times as large", ratio)
                   : fmt::format("{:.4g} times smaller", 1 / ratio);
}

/// "group screw2 is gone", "groups a, b and 3 more are new"; empty without names.
std::string groupsText(const std::vector<std::string>& names, std::string_view one,
                       std::string_view several) {
  constexpr std::size_t kMost = 4;
  if (names.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i) {
    list += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > kMost) list += fmt::format(" and {} more", names.size() - kMost);
  return names.size() == 1 ? fmt::format("group {} {}", list, one)
                           : fmt::format("groups {} {}", list, several);
}

/// The material of each part that a visual draws.
std::vector<const Material*> materialsOf(const Visual& visual) {
  std::vector<const Material*> materials;
  if (visual.mesh == nullptr) return materials;
  for (const std::size_t part : partsOf(visual)) {
    const std::size_t number = visual.mesh->parts[part].material;
    const bool has_own = number < visual.mesh->materials.size();
    materials.push_back(visual.material ? &*visual.material
                        : has_own       ? &visual.mesh->materials[number]
                                        : nullptr);
  }
  return materials;
}

/// Its opacity only where it is drawn.
glm::vec4 drawnColor(const Material& material) {
  glm::vec4 color = material.diffuse;
  if (material.alpha_mode == AlphaMode::opaque) color.a = 1.0F;
  return color;
}

bool isSameColor(const Material& a, const Material& b) {
  return drawnColor(a) == drawnColor(b) && a.specular == b.specular && a.emission == b.emission &&
         a.shininess == b.shininess;
}

std::string alphaText(const Material& material) {
  if (material.alpha_mode == AlphaMode::opaque) return "opaque";
  if (material.alpha_mode == AlphaMode::blend) return "blended";
  return fmt::format("cut out below {:.6g}", material.alpha_cutoff);
}

bool isMappedAlike(const Material& a, const Material& b) {
  return a.map_scale == b.map_scale && a.map_offset == b.map_offset &&
         a.map_rotation == b.map_rotation && a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v;
}

std::string colorText(const Material& material) {
  const auto byte = [](float value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
  };
  const glm::vec4 c = drawnColor(material);
  return fmt::format("#{:02x}{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b), byte(c.a));
}

}  // namespace

void LookDrift::add(const Model& recorded, const Model& given,
                    const std::map<std::string, std::string>& renamed, DriftList& drift) {
  std::map<std::string, bool> met;
  for (const Link& was : recorded.links) {
    const auto other = renamed.find(was.name);
    const std::string& name = other == renamed.end() ? was.name : other->second;
    const auto is = given.findLink(name);
    if (!is) {
      drift.add(
          "drift.link-removed",
          fmt::format("link {} of {} is gone: it would not be drawn, and what is drawn `in {}/{}` "
                      "would be placed in the world",
                      was.name, drift.subject(), drift.subject(), was.name));
      continue;
    }
    met[name] = true;
    if (name != was.name) {
      drift.add("drift.link-renamed",
                fmt::format("link {} of {} was renamed to {}: what the log shows, hides, colours "
                            "or attaches by the old name would miss it",
                            was.name, drift.subject(), name));
    }
    compareLinks(was, given.links[*is], drift);
  }
  for (const Link& is : given.links) {
    if (met.contains(is.name)) continue;
    drift.add("drift.link-added",
              fmt::format("link {} of {} is new: it would be drawn, and was not there when the "
                          "session was recorded",
                          is.name, drift.subject()));
  }
}

void LookDrift::compareLinks(const Link& was, const Link& is, DriftList& drift) {
  const std::string name = fmt::format("link {} of {}", is.name, drift.subject());
  if (const std::string shape = shapeDrift(was.visuals, is.visuals); !shape.empty()) {
    drift.add("drift.geometry", fmt::format("{} {}: it would be drawn differently", name, shape));
  }
  if (const std::string shape = shapeDrift(was.collisions, is.collisions); !shape.empty()) {
    drift.add("drift.collision", fmt::format("the collision shape of {} {}", name, shape));
  }
  const std::size_t shared = std::min(was.visuals.size(), is.visuals.size());
  for (std::size_t i = 0; i < shared; ++i) {
    const bool is_reported = comparePointColors(was.visuals[i], is.visuals[i], name, drift);
    compareMaterials(was.visuals[i], is.visuals[i], name, is_reported, drift);
  }
}

std::string LookDrift::shapeDrift(const std::vector<Visual>& was, const std::vector<Visual>& is) {
  if (was.size() != is.size()) {
    return fmt::format("had {} shapes, now has {}", was.size(), is.size());
  }
  for (std::size_t i = 0; i < was.size(); ++i) {
    const bool had = was[i].mesh != nullptr, has = is[i].mesh != nullptr;
    if (had != has) return has ? "has a mesh that was missing" : "lacks its mesh";
    if (had && shapeOf(was[i]) != shapeOf(is[i])) {
      return "has a different shape: " + shapeText(was[i], is[i]);
    }
    const Vec3 &a = was[i].scale, &b = is[i].scale;
    if (!isSameNumber(a.x, b.x) || !isSameNumber(a.y, b.y) || !isSameNumber(a.z, b.z)) {
      return fmt::format("has changed scale from {:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g}", a.x,
                         a.y, a.z, b.x, b.y, b.z);
    }
    if (const std::string moved = poseDrift(was[i].origin, is[i].origin); !moved.empty()) {
      return "has a shape that " + moved;
    }
  }
  return "";
}

std::string LookDrift::shapeText(const Visual& was, const Visual& is) {
  std::vector<std::string> texts;
  const auto add = [&](std::string text) {
    if (!text.empty()) texts.push_back(std::move(text));
  };
  const auto groupsOf = [&](const Visual& visual) {
    std::map<std::string, std::vector<Digest>> groups;
    for (const std::size_t part : partsOf(visual)) {
      const std::string& group = visual.mesh->parts[part].group;
      if (!group.empty()) groups[group].push_back(partOf(*visual.mesh, part));
    }
    return groups;
  };
  const auto before = groupsOf(was), after = groupsOf(is);
  std::vector<std::string> gone, added, changed;
  for (const auto& [group, digests] : before) {
    const auto now = after.find(group);
    if (now == after.end()) {
      gone.push_back(group);
    } else if (now->second != digests) {
      changed.push_back(group);
    }
  }
  for (const auto& [group, ignored] : after) {
    if (!before.contains(group)) added.push_back(group);
  }
  add(groupsText(gone, "is gone", "are gone"));
  add(groupsText(added, "is new", "are new"));
  // When all have changed, the whole has: its size follows.
  if (changed.size() < before.size()) {
    add(groupsText(changed, "has a different shape", "have different shapes"));
  }
  if (trianglesOf(was) != trianglesOf(is)) {
    add(fmt::format("had {} triangles, now {}", trianglesOf(was), trianglesOf(is)));
  }
  add(sizeText(was, is));
  if (texts.empty()) texts.emplace_back("points have moved within the same size");
  return fmt::format("{}", fmt::join(texts, ", "));
}

void LookDrift::compareMaterials(const Visual& was, const Visual& is, const std::string& name,
                                 bool is_color_reported, DriftList& drift) {
  const std::vector<const Material*> before = materialsOf(was), after = materialsOf(is);
  const Material plain;
  bool is_texture_reported = false;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    const Material& a = before[i] != nullptr ? *before[i] : plain;
    const Material& b = after[i] != nullptr ? *after[i] : plain;
    if (!is_color_reported && !isSameColor(a, b)) {
      is_color_reported = true;
      drift.add("drift.material",
                fmt::format("the material of {} has changed, its colour from {} to {}", name,
                            colorText(a), colorText(b)));
    }
    // Without texture and opacity no alpha mode shows.
    const bool has_alpha = !a.diffuse_map.empty() || !b.diffuse_map.empty() || a.diffuse.a < 1.0F ||
                           b.diffuse.a < 1.0F;
    if (!is_color_reported && has_alpha && alphaText(a) != alphaText(b)) {
      is_color_reported = true;
      drift.add("drift.material", fmt::format("the opacity of {} was {}, and is {}", name,
                                              alphaText(a), alphaText(b)));
    }
    const bool same_texture =
        textureOf(a) == textureOf(b) && (a.diffuse_map.empty() || isMappedAlike(a, b));
    if (!is_texture_reported && !same_texture) {
      is_texture_reported = true;
      drift.add("drift.texture",
                fmt::format("the texture of {} {}", name,
                            a.diffuse_map.empty()   ? "is new"
                            : b.diffuse_map.empty() ? "is gone"
                                                    : "is a different image, or is mapped "
                                                      "differently"));
    }
  }
}

bool LookDrift::comparePointColors(const Visual& was, const Visual& is, const std::string& name,
                                   DriftList& drift) {
  const bool had = was.mesh != nullptr && !was.mesh->colors.empty();
  const bool has = is.mesh != nullptr && !is.mesh->colors.empty();
  // A different shape has different colours too, and is already reported.
  const bool same = had == has && (!has || shapeOf(was) != shapeOf(is) ||
                                   pointColorsOf(was) == pointColorsOf(is));
  if (same) return false;
  drift.add("drift.material", fmt::format("the colours at the points of {} {}", name,
                                          has && had ? "have changed"
                                          : has      ? "are new"
                                                     : "are gone"));
  return true;
}

LookDrift::Digest LookDrift::pointColorsOf(const Visual& visual) {
  std::vector<std::uint32_t> colors;
  for (const std::size_t part : partsOf(visual)) {
    const MeshPart& run = visual.mesh->parts[part];
    for (std::size_t i = 0; i < run.index_count; ++i) {
      colors.push_back(visual.mesh->colors[visual.mesh->indices[run.first_index + i]]);
    }
  }
  return xxh3(std::as_bytes(std::span(colors)));
}

LookDrift::Digest LookDrift::shapeOf(const Visual& visual) {
  Bytes digests;
  for (const std::size_t part : partsOf(visual)) {
    const Digest digest = partOf(*visual.mesh, part);
    digests.insert(digests.end(), digest.begin(), digest.end());
  }
  return xxh3(digests);
}

LookDrift::Digest LookDrift::partOf(const Mesh& mesh, std::size_t part) {
  const auto [known, is_new] = parts_.try_emplace({&mesh, part});
  if (!is_new) return known->second;
  // By its corners: vertices are renumbered when another part of the file changes.
  const MeshPart& run = mesh.parts[part];
  std::vector<Vertex> corners;
  corners.reserve(run.index_count);
  for (std::size_t i = 0; i < run.index_count; ++i) {
    corners.push_back(mesh.vertices[mesh.indices[run.first_index + i]]);
  }
  known->second = xxh3(std::as_bytes(std::span(corners)));
  return known->second;
}

LookDrift::Digest LookDrift::textureOf(const Material& material) {
  if (material.diffuse_bytes != nullptr) return xxh3(*material.diffuse_bytes);
  if (material.diffuse_map.empty()) return {};
  const auto [known, is_new] = textures_.try_emplace(material.diffuse_map.string());
  if (!is_new) return known->second;
  const Result<std::string> picture = readFile(material.diffuse_map);
  known->second = xxh3(bytesOf(picture ? *picture : material.diffuse_map.filename().string()));
  return known->second;
}

}  // namespace rocinante
