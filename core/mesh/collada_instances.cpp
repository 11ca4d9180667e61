#include "core/mesh/collada_instances.h"

#include <fmt/format.h>

#include <charconv>

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

constexpr int kMaxControllers = 100;  // a skin of a skin of ...

}  // namespace

const ColladaInstances::Instance& ColladaInstances::of(Element& element) {
  const auto [found, is_new] = instances_.try_emplace(&element);
  if (!is_new) return found->second;
  found->second.geometry = geometryOf(element);
  if (found->second.geometry != nullptr) bind(element, found->second);
  return found->second;
}

/// Through controllers, whose skins and morphs are drawn as the mesh that they bend.
Element* ColladaInstances::geometryOf(Element& instance) {
  if (std::string_view(instance.Name()) == "instance_geometry") {
    return document_.follow(instance, "url", "geometry");
  }
  ColladaDocument::children(instance, "skeleton");
  Element* controller = document_.follow(instance, "url", "controller");
  for (int i = 0; controller != nullptr && i < kMaxControllers; ++i) {
    Element* bent = controller->FirstChildElement("skin");
    if (bent == nullptr) bent = controller->FirstChildElement("morph");
    if (bent == nullptr) return nullptr;
    const std::string_view url = ColladaDocument::attribute(*bent, "source");
    Element* const next =
        url.starts_with('#') ? document_.find("controller", url.substr(1)) : nullptr;
    if (next == nullptr) return document_.follow(*bent, "source", "geometry");
    controller = next;
  }
  if (controller != nullptr) {
    document_.faults().warning("collada.bad-reference", ColladaDocument::placeOf(instance),
                               "its <controller> leads to no mesh but back to itself");
  }
  return nullptr;
}

void ColladaInstances::bind(Element& element, Instance& instance) {
  Element* const bind = ColladaDocument::child(element, "bind_material");
  Element* const common =
      bind == nullptr ? nullptr : ColladaDocument::child(*bind, "technique_common");
  if (common == nullptr) return;
  for (Element* each = common->FirstChildElement("instance_material"); each != nullptr;
       each = each->NextSiblingElement("instance_material")) {
    ColladaDocument::use(*each);
    Element* const material = document_.follow(*each, "target", "material");
    if (material == nullptr) continue;
    Bound bound{materials_.number(*material), std::nullopt};
    for (Element* input : ColladaDocument::children(*each, "bind_vertex_input")) {
      if (ColladaDocument::attribute(*input, "semantic") != materials_.texcoord(bound.material) ||
          ColladaDocument::attribute(*input, "input_semantic") != "TEXCOORD") {
        continue;
      }
      bound.set = ColladaDocument::numberOf(*input, "input_set", 0);
    }
    instance.by_symbol.emplace(ColladaDocument::attribute(*each, "symbol"), bound);
  }
}

/// The material of a primitive; also by its own id, and by what else is bound there, as other
/// readers do.
ColladaInstances::Bound ColladaInstances::boundOf(const ColladaPrimitive& primitive,
                                                  const Instance& instance) {
  const auto& binding = instance.by_symbol;
  if (const auto found = binding.find(primitive.material); found != binding.end()) {
    return found->second;
  }
  if (Element* const named = document_.find("material", primitive.material)) {
    return {materials_.number(*named), std::nullopt};
  }
  if (primitive.material.empty() && binding.size() == 1) return binding.begin()->second;
  if (!primitive.material.empty() && !binding.empty()) {
    document_.faults().warning(
        "collada.bad-reference", ColladaDocument::placeOf(*primitive.element),
        fmt::format("<{}> has the material {}, which no <instance_material> binds",
                    primitive.element->Name(), quotedInFault(primitive.material)),
        "it is drawn grey");
  }
  return {materials_.grey(), std::nullopt};
}

const ColladaInput* ColladaInstances::texcoordOf(const ColladaPrimitive& primitive,
                                                 const Bound& bound) const {
  std::optional<std::uint64_t> wanted = bound.set;
  if (!wanted) {
    // "UVSET1", "TEX0": exporters that bind nothing number the names.
    const std::string& name = materials_.texcoord(bound.material);
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    std::uint64_t number = 0;
    const auto read = std::from_chars(name.data() + digits, name.data() + name.size(), number);
    if (read.ec == std::errc()) wanted = number;
  }
  const ColladaInput* first = nullptr;
  for (const ColladaInput& input : primitive.inputs) {
    if (input.semantic != "TEXCOORD") continue;
    if (first == nullptr) first = &input;
    if (wanted == input.set) return &input;
  }
  return first;
}

}  // namespace rocinante
