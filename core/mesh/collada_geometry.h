#pragma once

#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mesh/collada_document.h"
#include "core/mesh/collada_primitive.h"

namespace rocinante {

/// The meshes of a COLLADA file, each read when it is first asked for. What is malformed is a fault
/// and left out; the rest is used.
class ColladaGeometries {
 public:
  explicit ColladaGeometries(ColladaDocument& document) : document_(document) {}

  const std::vector<ColladaPrimitive>& of(ColladaDocument::Element& geometry);
  /// What an input reads, marked as used; null with a fault when it leads nowhere.
  const ColladaSource* source(const ColladaInput& input);

 private:
  const std::vector<double>& numbersOf(ColladaDocument::Element& array);
  std::unique_ptr<ColladaSource> readSource(ColladaDocument::Element& source,
                                            std::string_view semantic);
  void readPrimitive(ColladaDocument::Element& element, std::vector<ColladaPrimitive>& all);

  ColladaDocument& document_;
  std::size_t values_ = 0;  ///< of all sources
  std::map<const ColladaDocument::Element*, std::vector<ColladaPrimitive>> geometries_;
  std::map<std::pair<const ColladaDocument::Element*, std::string_view>,
           std::unique_ptr<ColladaSource>>
      sources_;
  std::map<const ColladaDocument::Element*, std::vector<double>> arrays_;
};

}  // namespace rocinante
