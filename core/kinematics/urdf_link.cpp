#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/name_hint.h"
#include "core/document/fault_list.h"
#include "core/kinematics/urdf_element.h"
#include "core/kinematics/visual_materials.h"

namespace rocinante {

std::optional<Material> UrdfLinkReader::readMaterial(const UrdfElement& element) {
  const auto color = element.child("color");
  const auto texture = element.child("texture");
  if (!color && !texture) return std::nullopt;
  Material material;
  material.name = element.text("name");
  if (color) {
    if (!color->has("rgba")) {
      element.faults().error("urdf.missing-attribute", color->place(),
                             "<color> lacks its attribute `rgba`");
    }
    if (const auto rgba = color->vector4("rgba")) {
      for (int i = 0; i < 4; ++i) {
        if ((*rgba)[i] < 0.0 || (*rgba)[i] > 1.0) {
          element.faults().warning("urdf.color-range", color->place("rgba"),
                                   fmt::format("a colour of material {} is outside 0 to 1",
                                               quotedInFault(material.name)),
                                   "it is clamped");
          break;
        }
      }
      for (int i = 0; i < 4; ++i) {
        material.diffuse[i] = static_cast<float>(std::clamp((*rgba)[i], 0.0, 1.0));
      }
    }
  } else {
    material.diffuse = {1.0F, 1.0F, 1.0F, 1.0F};
  }
  if (texture) {
    if (const auto file = texture->requiredText("filename")) {
      material.diffuse_map =
          meshes_.texture(*file, folder_, texture->place("filename"), element.faults());
      if (material.diffuse_map.empty()) material.missing_map = *file;
    }
  }
  return material;
}

void UrdfLinkReader::define(const UrdfElement& element, const Material& material) {
  const auto [known, is_new] = materials_.try_emplace(material.name, material);
  if (is_new) {
    material_places_[material.name] = element.place();
  } else if (known->second != material) {
    element.faults().warning(
        "urdf.material-redefined", element.place(),
        fmt::format("material {} was defined differently in line {}", quotedInFault(material.name),
                    material_places_[material.name].line),
        "the first one is used where only the name is given");
  }
}

void UrdfLinkReader::addMaterial(const UrdfElement& element) {
  const auto material = readMaterial(element);
  if (!material) return;
  if (material->name.empty()) {
    element.faults().error("urdf.missing-attribute", element.place(),
                           "<material> lacks its attribute `name`");
    return;
  }
  define(element, *material);
}

std::optional<double> UrdfLinkReader::size(const UrdfElement& shape, const char* attribute) const {
  const auto value = shape.requiredNumber(attribute);
  if (!value) return std::nullopt;
  if (*value > 0.0 && *value < 1e9) return value;
  shape.faults().error(
      "urdf.bad-size", shape.place(attribute),
      fmt::format("`{}` of <{}> must be above 0 and below 1e9", attribute, shape.tag()));
  return std::nullopt;
}

std::shared_ptr<const Mesh> UrdfLinkReader::readShape(const UrdfElement& shape, Vec3& scale,
                                                      bool& sound) {
  sound = false;
  const auto make = [&](ShapeSize::Kind kind, double x, double y, double z) {
    return meshes_.shape({kind, {x, y, z}}, scale, shape.place(), shape.faults());
  };
  if (shape.tag() == "sphere") {
    const auto radius = size(shape, "radius");
    if (!radius) return nullptr;
    sound = true;
    return make(ShapeSize::Kind::sphere, *radius, *radius, *radius);
  }
  if (shape.tag() == "cylinder" || shape.tag() == "capsule") {
    const auto radius = size(shape, "radius"), length = size(shape, "length");
    if (!radius || !length) return nullptr;
    sound = true;
    const bool is_cylinder = shape.tag() == "cylinder";
    return make(is_cylinder ? ShapeSize::Kind::cylinder : ShapeSize::Kind::capsule, *radius,
                *radius, *length);
  }
  if (shape.tag() == "box") {
    if (!shape.has("size")) {
      shape.faults().error("urdf.missing-attribute", shape.place(),
                           "<box> lacks its attribute `size`");
    }
    const auto sides = shape.vector("size");
    if (!sides) return nullptr;
    for (int i = 0; i < 3; ++i) {
      if ((*sides)[i] > 0.0 && (*sides)[i] < 1e9) continue;
      shape.faults().error("urdf.bad-size", shape.place("size"),
                           "`size` of <box> must be above 0 and below 1e9");
      return nullptr;
    }
    sound = true;
    return make(ShapeSize::Kind::box, sides->x, sides->y, sides->z);
  }
  const auto file = shape.requiredText("filename");
  scale = shape.vector("scale").value_or(Vec3{1, 1, 1});
  for (int i = 0; i < 3; ++i) {
    if (scale[i] != 0.0 && std::abs(scale[i]) < 1e9) continue;
    shape.faults().error("urdf.bad-size", shape.place("scale"),
                         scale[i] == 0.0 ? "`scale` of <mesh> must not be 0 in any direction"
                                         : "`scale` of <mesh> must be between -1e9 and 1e9");
    return nullptr;
  }
  sound = true;
  if (!file) return nullptr;  // the picture lacks it, as one whose file is missing
  return meshes_.load(*file, folder_, 1.0, UpAxis::z, shape.place("filename"), shape.faults());
}

std::optional<Visual> UrdfLinkReader::readGeometry(const UrdfElement& owner,
                                                   const std::string& link) {
  const auto geometry = owner.child("geometry");
  if (!geometry) {
    owner.faults().error("urdf.missing-element", owner.place(),
                         fmt::format("<{}> has no <geometry>", owner.tag()));
    return std::nullopt;
  }
  std::optional<UrdfElement> shape;
  geometry->eachChild([&](const UrdfElement& below) {
    for (const std::string_view known : {"box", "cylinder", "sphere", "capsule", "mesh"}) {
      if (below.tag() != known) continue;
      if (shape) {
        owner.faults().error("urdf.several-shapes", below.place(), "<geometry> has a second shape",
                             "one shape per <visual>; a link may have several visuals");
      } else {
        shape = below;
      }
    }
  });
  if (!shape) {
    owner.faults().error("urdf.no-shape", geometry->place(), "<geometry> has no known shape",
                         "shapes are box, cylinder, sphere, capsule, mesh");
    return std::nullopt;
  }
  Visual visual;
  visual.name = owner.text("name");
  visual.origin = owner.origin();
  bool sound = false;
  visual.mesh = readShape(*shape, visual.scale, sound);
  if (!sound) return std::nullopt;
  if (shape->tag() == "mesh" && visual.mesh) {
    const Vec3 sides = (visual.mesh->bounds.max - visual.mesh->bounds.min) * visual.scale;
    mesh_uses_.push_back({link, shape->text("filename"), owner.tag() == "collision",
                          std::sqrt(glm::dot(sides, sides)), shape->place("filename")});
  }
  return visual;
}

void UrdfLinkReader::readVisual(const UrdfElement& element, Link& link) {
  const auto given = element.child("material");
  std::optional<Material> material;
  if (given) {
    material = readMaterial(*given);
    if (material && !material->name.empty()) define(*given, *material);
  }
  auto visual = readGeometry(element, link.name);
  if (!visual) return;
  // Parts with a material of their own keep it, as in RViz; the URDF's is for the others.
  PartsByMaterial parts;
  if (given && visual->mesh) parts = partsByMaterial(*visual->mesh);
  const bool takes_none = given && !parts.own.empty() && parts.plain.empty();
  if (given && !parts.own.empty() && !parts.plain.empty()) {
    Visual& own = link.visuals.emplace_back(*visual);
    own.mesh_parts = std::move(parts.own);
    visual->mesh_parts = std::move(parts.plain);
  }
  if (given && !material) {
    const auto number = takes_none ? std::nullopt : std::optional(link.visuals.size());
    wanted_.push_back({link_count_, number, given->text("name"), given->place()});
  }
  if (!takes_none) visual->material = material;
  link.visuals.push_back(std::move(*visual));
}

std::optional<LinkDraft> UrdfLinkReader::readLink(const UrdfElement& element) {
  const auto name = element.requiredText("name");
  if (!name) return std::nullopt;
  LinkDraft draft;
  draft.place = element.place();
  draft.link.name = *name;
  element.each("visual", [&](const UrdfElement& below) { readVisual(below, draft.link); });
  element.each("collision", [&](const UrdfElement& below) {
    if (auto collision = readGeometry(below, draft.link.name)) {
      draft.link.collisions.push_back(std::move(*collision));
    }
  });
  ++link_count_;
  return draft;
}

void UrdfLinkReader::resolveMaterials(std::vector<LinkDraft>& links, FaultList& faults) const {
  for (const Wanted& wanted : wanted_) {
    const auto found = materials_.find(wanted.material);
    if (found != materials_.end()) {
      if (!wanted.visual) continue;
      links[wanted.link].link.visuals[*wanted.visual].material = found->second;
      continue;
    }
    std::vector<std::string_view> names;
    if (faults.lists("urdf.unknown-material")) {
      for (const auto& [name, material] : materials_) names.push_back(name);
    }
    faults.error("urdf.unknown-material", wanted.place,
                 wanted.material.empty()
                     ? std::string("<material> has neither a name nor a colour nor a texture")
                     : fmt::format("no material is named {}", quotedInFault(wanted.material)),
                 didYouMean(wanted.material, names));
  }
}

}  // namespace rocinante
