#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/vector.h"
#include "core/mesh/collada_document.h"

namespace rocinante {

/// A <node>, read once however often it is instanced.
struct ColladaNode {
  std::string_view name;
  Mat4 transform{1.0};
  std::vector<ColladaDocument::Element*> meshes;  ///< <instance_geometry> and <instance_controller>
  std::vector<std::size_t> children;              ///< also those that <instance_node> names
  std::size_t size = 0;  ///< nodes and meshes in all, below and instanced; once counted
  bool counting = false;
};

/// The nodes of the scene that a COLLADA file shows.
class ColladaNodes {
 public:
  explicit ColladaNodes(ColladaDocument& document) : document_(document) {}

  /// damaged: nodes that contain themselves, or more than 1,000,000 after all instances are
  /// expanded. The error lacks the file's name.
  Status read();

  /// The outermost nodes. Their tree ends, and is at most 1,000 deep.
  const std::vector<std::size_t>& roots() const { return roots_; }
  const ColladaNode& at(std::size_t number) const { return nodes_[number]; }

 private:
  std::size_t numberOf(ColladaDocument::Element& node);
  void readNode(ColladaDocument::Element& element, std::size_t number);
  Mat4 transformOf(ColladaDocument::Element& element);
  std::string count(std::size_t number, std::size_t depth);

  ColladaDocument& document_;
  std::vector<ColladaNode> nodes_;
  std::vector<ColladaDocument::Element*> waiting_;  ///< by number: to be read
  std::map<const ColladaDocument::Element*, std::size_t> numbers_;
  std::vector<std::size_t> roots_;
};

}  // namespace rocinante
