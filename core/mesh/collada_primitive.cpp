#include "core/mesh/collada_primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/polygon.h"

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

constexpr std::size_t kMaxHoledCorners = 512;  // joining holes is cubic

/// Cuts the polygons of one primitive into its triangles.
class PrimitiveReader {
 public:
  PrimitiveReader(ColladaDocument& document, Element& element, ColladaPrimitive& primitive)
      : document_(document), element_(element), primitive_(primitive) {}

  void read() {
    const std::string_view kind = element_.Name();
    if (kind == "triangles") {
      readTriangles();
    } else if (kind == "polylist") {
      readPolylist();
    } else if (kind == "polygons") {
      readPolygons();
    } else {
      readStrips(kind == "trifans");
    }
  }

 private:
  void readTriangles() {
    addLists();
    const std::size_t corners = cornerCount(0);
    expectCount(corners / 3);
    for (std::size_t i = 0; i + 2 < corners; i += 3) addPolygon(i, 3);
    if (corners % 3 != 0) badCount(fmt::format("{} corners are not whole triangles", corners));
  }

  void readPolylist() {
    std::vector<std::uint32_t> sizes;
    for (Element* each : ColladaDocument::children(element_, "vcount")) {
      document_.addIndices(*each, sizes);
    }
    addLists();
    expectCount(sizes.size());
    const std::size_t corners = cornerCount(0);
    std::size_t next = 0;
    for (const std::uint32_t size : sizes) {
      if (size > corners - next) {
        return badCount(fmt::format("<vcount> asks for more than the {} corners of <p>", corners));
      }
      addPolygon(next, size);
      next += size;
    }
    if (next < corners) {
      badCount(fmt::format("<p> has {} corners, of which <vcount> uses {}", corners, next));
    }
  }

  void readPolygons() {
    std::size_t count = 0;
    for (Element* each = element_.FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      const std::string_view name = each->Name();
      if (name != "p" && name != "ph") continue;
      ColladaDocument::use(*each);
      ++count;
      if (name == "p") {
        const std::size_t from = addList(*each);
        addPolygon(from, cornerCount(from));
      } else {
        addHoledPolygon(*each);
      }
    }
    expectCount(count);
  }

  void readStrips(bool fans) {
    const std::vector<Element*> strips = ColladaDocument::children(element_, "p");
    expectCount(strips.size());
    for (Element* strip : strips) {
      const std::size_t from = addList(*strip), corners = cornerCount(from);
      if (corners < 3) badCount(fmt::format("a strip or fan of {} corners", corners));
      for (std::size_t i = 2; i < corners; ++i) {
        const bool odd = !fans && i % 2 == 1;
        const std::size_t a = fans ? from : odd ? from + i - 1 : from + i - 2;
        const std::size_t b = odd ? from + i - 2 : from + i - 1;
        if (!arePoints(a, 1) || !arePoints(b, 1) || !arePoints(from + i, 1)) continue;
        addTriangle(a, b, from + i);
      }
    }
  }

  void addHoledPolygon(Element& element) {
    Element* const outline = ColladaDocument::child(element, "p");
    if (outline == nullptr) return badCount("<ph> lacks its <p>");
    const std::size_t from = addList(*outline);
    std::vector<std::size_t> ends = {cornerCount(from)};
    for (Element* hole : ColladaDocument::children(element, "h")) {
      addList(*hole);
      if (cornerCount(from) > ends.back()) ends.push_back(cornerCount(from));
    }
    const std::size_t corners = ends.back();
    if (ends.size() == 1) return addPolygon(from, corners);
    if (!arePoints(from, corners)) return;
    if (ends.front() < 3 || corners > kMaxHoledCorners) {
      document_.faults().leaveOut(
          "primitive", "polygon with holes", ColladaDocument::placeOf(element),
          fmt::format("those of 3 to {} corners are drawn", kMaxHoledCorners), Severity::warning);
      return;
    }
    loadPoints(from, corners);
    const std::vector<std::uint32_t> loop = loopAroundHoles(points_, ends);
    std::vector<glm::vec3> ring;
    for (const std::uint32_t corner : loop) ring.push_back(points_[corner]);
    const auto cut = cutter_.cut(ring);
    for (std::size_t i = 0; i < cut.size(); i += 3) {
      addTriangle(from + loop[cut[i]], from + loop[cut[i + 1]], from + loop[cut[i + 2]]);
    }
  }

  void addPolygon(std::size_t from, std::size_t corners) {
    if (corners < 3) {
      document_.faults().leaveOut("primitive", fmt::format("polygon of {} corners", corners),
                                  ColladaDocument::placeOf(element_), "it has no surface",
                                  Severity::warning);
      return;
    }
    if (!arePoints(from, corners)) return;
    if (corners == 3) return addTriangle(from, from + 1, from + 2);
    loadPoints(from, corners);
    const auto cut = cutter_.cut(points_);
    for (std::size_t i = 0; i < cut.size(); i += 3) {
      addTriangle(from + cut[i], from + cut[i + 1], from + cut[i + 2]);
    }
    if (cutter_.gaveUp()) {
      document_.faults().leaveOut("value", "concavity", ColladaDocument::placeOf(element_),
                                  "large concave polygons are drawn as if they were convex",
                                  Severity::warning);
    }
  }

  void addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t corner : {a, b, c}) {
      primitive_.corners.push_back(static_cast<std::uint32_t>(corner));
    }
  }

  /// Whether the corners have positions; a fault where not.
  bool arePoints(std::size_t from, std::size_t corners) {
    for (std::size_t i = from; i < from + corners; ++i) {
      const std::uint32_t index = position(i);
      if (index >= primitive_.positions->count) {
        document_.faults().error("collada.bad-index", ColladaDocument::placeOf(element_),
                                 fmt::format("<{}> uses point {} of {}", element_.Name(), index,
                                             primitive_.positions->count),
                                 "the polygon is left out");
        return false;
      }
      const glm::vec3 point = pointOf(index);
      if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) continue;
      document_.faults().error(
          "mesh.bad-triangle", ColladaDocument::placeOf(element_),
          fmt::format("<{}> has a polygon with a corner that is not finite", element_.Name()),
          "it is left out");
      return false;
    }
    return true;
  }

  void loadPoints(std::size_t from, std::size_t corners) {
    points_.clear();
    for (std::size_t i = from; i < from + corners; ++i) points_.push_back(pointOf(position(i)));
  }

  glm::vec3 pointOf(std::uint32_t index) const {
    const ColladaSource& points = *primitive_.positions;
    return {points.at(index, 0), points.at(index, 1), points.at(index, 2)};
  }

  std::uint32_t position(std::size_t corner) const {
    return primitive_.indices[corner * primitive_.stride + primitive_.position_offset];
  }

  /// Corners after the first `from`.
  std::size_t cornerCount(std::size_t from) const {
    return primitive_.indices.size() / primitive_.stride - from;
  }

  /// Adds a <p> or <h>, and returns the number of its first corner.
  std::size_t addList(Element& list) {
    const std::size_t from = cornerCount(0);
    document_.addIndices(list, primitive_.indices);
    const std::size_t over = primitive_.indices.size() % primitive_.stride;
    if (over == 0) return from;
    primitive_.indices.resize(primitive_.indices.size() - over);
    badCount(
        fmt::format("<{}> ends within a corner of {} indices", list.Name(), primitive_.stride));
    return from;
  }
  void addLists() {
    for (Element* list : ColladaDocument::children(element_, "p")) addList(*list);
  }

  void expectCount(std::size_t count) {
    const std::uint64_t claimed = ColladaDocument::numberOf(element_, "count", count);
    if (claimed == count) return;
    badCount(fmt::format("<{}> has {} primitives, and claims {}", element_.Name(), count, claimed),
             claimed > count ? Severity::error : Severity::warning);
  }

  void badCount(std::string text, Severity severity = Severity::error) {
    document_.faults().add(severity, "collada.bad-count", ColladaDocument::placeOf(element_),
                           std::move(text));
  }

  ColladaDocument& document_;
  Element& element_;
  ColladaPrimitive& primitive_;
  std::vector<glm::vec3> points_;
  PolygonCutter cutter_;
};

}  // namespace

const ColladaInput* ColladaPrimitive::input(std::string_view semantic) const {
  const auto found = std::ranges::find(inputs, semantic, &ColladaInput::semantic);
  return found == inputs.end() ? nullptr : &*found;
}

void readColladaPrimitive(ColladaDocument& document, Element& element,
                          ColladaPrimitive& primitive) {
  PrimitiveReader(document, element, primitive).read();
}

}  // namespace rocinante
