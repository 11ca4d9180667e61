#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "core/mesh/collada_document.h"
#include "core/mesh/collada_materials.h"
#include "core/mesh/collada_primitive.h"

namespace rocinante {

/// What <instance_geometry> and <instance_controller> show, each read once.
class ColladaInstances {
 public:
  /// A material, and the set of texture coordinates that its image is bound to.
  struct Bound {
    std::uint32_t material;
    std::optional<std::uint64_t> set;
  };
  struct Instance {
    ColladaDocument::Element* geometry = nullptr;
    std::map<std::string_view, Bound> by_symbol;
  };

  /// Both are borrowed.
  ColladaInstances(ColladaDocument& document, ColladaMaterials& materials)
      : document_(document), materials_(materials) {}

  /// Without a geometry, with a fault, when its references lead to none.
  const Instance& of(ColladaDocument::Element& instance);
  Bound boundOf(const ColladaPrimitive& primitive, const Instance& instance);
  /// The texture coordinates that the material's image asks for; null without any.
  const ColladaInput* texcoordOf(const ColladaPrimitive& primitive, const Bound& bound) const;

 private:
  ColladaDocument::Element* geometryOf(ColladaDocument::Element& instance);
  void bind(ColladaDocument::Element& element, Instance& instance);

  ColladaDocument& document_;
  ColladaMaterials& materials_;
  std::map<const ColladaDocument::Element*, Instance> instances_;
};

}  // namespace rocinante
