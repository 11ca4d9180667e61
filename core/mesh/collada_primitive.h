#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/mesh/collada_document.h"

namespace rocinante {

/// Values that an <accessor> reads from an array; never beyond its end.
struct ColladaSource {
  const std::vector<double>* numbers = nullptr;
  std::size_t offset = 0, stride = 1, count = 0;
  /// Places of x y z, r g b a or s t within one value; `stride` where it has none.
  std::array<std::size_t, 4> component{};

  /// `index` is below `count`.
  double at(std::size_t index, std::size_t which, double missing = 0.0) const {
    if (component[which] >= stride) return missing;
    return (*numbers)[offset + index * stride + component[which]];
  }
};

/// An <input> of a primitive, or of the <vertices> that it names.
struct ColladaInput {
  ColladaDocument::Element* element = nullptr;
  std::string_view semantic;
  std::uint64_t set = 0;
  std::size_t offset = 0;
};

/// Triangles, polygons, strips or fans of one material, cut into triangles.
struct ColladaPrimitive {
  const ColladaDocument::Element* element = nullptr;
  std::string_view material;  ///< its symbol
  std::vector<ColladaInput> inputs;
  std::size_t stride = 1;              ///< indices per corner
  std::vector<std::uint32_t> indices;  ///< `stride` for each corner of the file
  std::vector<std::uint32_t> corners;  ///< three per triangle; their positions exist and are finite
  const ColladaSource* positions = nullptr;
  std::size_t position_offset = 0;

  std::uint32_t index(std::uint32_t corner, std::size_t input_offset) const {
    return indices[corner * stride + input_offset];
  }
  const ColladaInput* input(std::string_view semantic) const;
};

/// Reads the lists of a <triangles>, <polylist>, <polygons>, <tristrips> or <trifans> into
/// `primitive`, whose inputs and positions are known. A polygon with an index or a position that is
/// wrong is a fault and left out.
void readColladaPrimitive(ColladaDocument& document, ColladaDocument::Element& element,
                          ColladaPrimitive& primitive);

}  // namespace rocinante
