#include "core/mesh/collada_nodes.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

constexpr std::size_t kLongestNodeChain = 1000;  // of instanced nodes
constexpr std::size_t kMaxExpanded = 1'000'000;  // with meshes, after all instances are expanded

/// Where `eye` looks along -z towards `interest`, with `up` above.
Mat4 lookAt(const Vec3& eye, const Vec3& interest, const Vec3& up) {
  const auto back = normalized(eye - interest);
  const auto right = back ? normalized(crossOf(up, *back)) : std::nullopt;
  if (!right) return translationMatrix(eye);
  const Vec3 above = crossOf(*back, *right);
  return Mat4(Vec4(*right, 0), Vec4(above, 0), Vec4(*back, 0), Vec4(eye, 1));
}

/// As RenderMan's Skew: moves points along `way`, so that the direction `from` leans towards it by
/// the angle. Empty when it would lean as far as `way` or its opposite.
std::optional<Mat4> skewMatrix(double angle, const Vec3& from, const Vec3& way) {
  const auto along = normalized(way), tilted = normalized(from);
  if (!along || !tilted) return std::nullopt;
  const double part = dotOf(*tilted, *along);
  const auto across = normalized(*tilted - part * *along);
  if (!across) return std::nullopt;
  const double before = arcTangent2(part, dotOf(*tilted, *across));
  if (!(std::fabs(before + angle) < kPi / 2)) return std::nullopt;
  const double shift = tangent(before + angle) - tangent(before);
  Mat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) matrix[i] += Vec4(shift * (*across)[i] * *along, 0.0);
  return matrix;
}

}  // namespace

Status ColladaNodes::read() {
  Element* const shown = ColladaDocument::child(document_.root(), "scene");
  Element* const instance =
      shown == nullptr ? nullptr : ColladaDocument::child(*shown, "instance_visual_scene");
  Element* scene =
      instance == nullptr ? nullptr : document_.follow(*instance, "url", "visual_scene");
  if (scene == nullptr) {
    // A library of scenes shows none by itself; its first is better than nothing.
    Element* const library = ColladaDocument::child(document_.root(), "library_visual_scenes");
    scene = library == nullptr ? nullptr : ColladaDocument::child(*library, "visual_scene");
    if (scene == nullptr) return {};
    if (instance == nullptr) {
      document_.faults().warning(
          "collada.bad-reference", ColladaDocument::placeOf(document_.root()),
          "the file has no <scene> that it shows", "its first <visual_scene> is drawn");
    }
  }
  for (Element* node : ColladaDocument::children(*scene, "node")) roots_.push_back(numberOf(*node));
  for (std::size_t i = 0; i < waiting_.size(); ++i) readNode(*waiting_[i], i);
  std::size_t size = 0;
  for (const std::size_t root : roots_) {
    std::string problem = count(root, 0);
    size += nodes_[root].size;
    if (problem.empty() && size > kMaxExpanded) {
      problem = fmt::format("its nodes expand to more than {} nodes", kMaxExpanded);
    }
    if (!problem.empty()) return Error{ErrorKind::damaged, std::move(problem), {}};
  }
  return {};
}

std::size_t ColladaNodes::numberOf(Element& node) {
  const auto [found, is_new] = numbers_.emplace(&node, nodes_.size());
  if (is_new) {
    nodes_.emplace_back();
    waiting_.push_back(&node);
  }
  return found->second;
}

void ColladaNodes::readNode(Element& element, std::size_t number) {
  ColladaNode node;
  node.name = ColladaDocument::attribute(element, "name");
  node.transform = transformOf(element);
  for (Element* each = element.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    const std::string_view kind = each->Name();
    if (kind == "node") {
      ColladaDocument::use(*each);
      node.children.push_back(numberOf(*each));
    } else if (kind == "instance_node") {
      ColladaDocument::use(*each);
      Element* const instanced = document_.follow(*each, "url", "node");
      if (instanced != nullptr) node.children.push_back(numberOf(*instanced));
    } else if (kind == "instance_geometry" || kind == "instance_controller") {
      ColladaDocument::use(*each);
      node.meshes.push_back(each);
    }
  }
  nodes_[number] = std::move(node);
}

Mat4 ColladaNodes::transformOf(Element& element) {
  Mat4 transform(1.0);
  for (Element* each = element.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    const std::string_view kind = each->Name();
    const std::size_t size = kind == "matrix"                         ? 16
                             : kind == "lookat"                       ? 9
                             : kind == "skew"                         ? 7
                             : kind == "rotate"                       ? 4
                             : kind == "translate" || kind == "scale" ? 3
                                                                      : 0;
    if (size == 0) continue;
    ColladaDocument::use(*each);
    const std::vector<double> n = document_.numbers(*each, size);
    if (n.empty()) continue;
    if (kind == "matrix") {
      Mat4 matrix(1.0);
      for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = n[static_cast<std::size_t>(i)];
      transform = transform * matrix;
    } else if (kind == "lookat") {
      transform = transform * lookAt({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
    } else if (kind == "skew") {
      const auto skew = skewMatrix(radiansOf(n[0]), {n[1], n[2], n[3]}, {n[4], n[5], n[6]});
      if (skew) {
        transform = transform * *skew;
      } else {
        document_.faults().error("collada.bad-value", ColladaDocument::placeOf(*each),
                                 "<skew> has axes that are equal or 0, or an angle beyond them",
                                 "the node is drawn unskewed");
      }
    } else if (kind == "rotate") {
      const auto axis = normalized(Vec3(n[0], n[1], n[2]));
      if (axis) transform = transform * rotationMatrix(quaternionAbout(*axis, radiansOf(n[3])));
    } else if (kind == "translate") {
      transform = transform * translationMatrix({n[0], n[1], n[2]});
    } else {
      transform = transform * scaleMatrix({n[0], n[1], n[2]});
    }
  }
  return transform;
}

/// Why the tree below a node is refused; else empty, with its size noted.
std::string ColladaNodes::count(std::size_t number, std::size_t depth) {
  if (nodes_[number].size > 0) return {};
  if (nodes_[number].counting) return "a <node> contains itself by way of <instance_node>";
  if (depth > kLongestNodeChain) {
    return fmt::format("its nodes instance each other in a chain of more than {}",
                       kLongestNodeChain);
  }
  nodes_[number].counting = true;
  std::size_t size = 1 + nodes_[number].meshes.size();
  for (const std::size_t child : nodes_[number].children) {
    if (std::string problem = count(child, depth + 1); !problem.empty()) return problem;
    size += nodes_[child].size;
    if (size > kMaxExpanded)
      return fmt::format("its nodes expand to more than {} nodes", kMaxExpanded);
  }
  nodes_[number].counting = false;
  nodes_[number].size = size;
  return {};
}

}  // namespace rocinante
