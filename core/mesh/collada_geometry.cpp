#include "core/mesh/collada_geometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

constexpr std::uint64_t kMaxOffset = 65535;
constexpr std::size_t kMaxValues = std::size_t{1} << 26U;  // in all sources that are used
constexpr std::size_t kMaxInputs = 256;                    // of one primitive

bool isSurface(std::string_view name) {
  return name == "triangles" || name == "polylist" || name == "polygons" || name == "tristrips" ||
         name == "trifans";
}

/// Where the components of one value are, by the names of its parameters; one without a name is
/// passed over (COLLADA 1.4, <accessor>).
std::array<std::size_t, 4> componentsOf(const std::vector<Element*>& params, std::size_t stride,
                                        std::string_view semantic) {
  std::array<std::size_t, 4> component{};
  component.fill(stride);
  std::vector<std::size_t> in_order;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (!ColladaDocument::attribute(*params[i], "name").empty()) in_order.push_back(i);
  }
  if (in_order.empty()) in_order = {0, 1, 2, 3};
  for (std::size_t i = 0; i < std::min<std::size_t>(in_order.size(), 4); ++i) {
    component[i] = in_order[i];
  }
  const std::string_view letters = semantic == "COLOR"      ? "RGBA"
                                   : semantic == "TEXCOORD" ? "ST"
                                                            : "XYZ";
  for (std::size_t i = 0; i < params.size(); ++i) {
    const std::string_view name = ColladaDocument::attribute(*params[i], "name");
    if (name.size() != 1) continue;
    const std::size_t place = letters.find(name);
    if (place != std::string_view::npos) component[place] = i;
  }
  return component;
}

}  // namespace

const std::vector<double>& ColladaGeometries::numbersOf(Element& array) {
  const auto [found, is_new] = arrays_.try_emplace(&array);
  if (!is_new) return found->second;
  found->second = document_.numbers(array);
  const std::size_t count = found->second.size();
  const std::uint64_t claimed = ColladaDocument::numberOf(array, "count", count);
  if (claimed != count) {
    document_.faults().add(
        claimed > count ? Severity::error : Severity::warning, "collada.bad-count",
        ColladaDocument::placeOf(array),
        fmt::format("<{}> has {} numbers, and claims {}", array.Name(), count, claimed));
  }
  return found->second;
}

std::unique_ptr<ColladaSource> ColladaGeometries::readSource(Element& source,
                                                             std::string_view semantic) {
  Element* const common = ColladaDocument::child(source, "technique_common");
  Element* const accessor =
      common == nullptr ? nullptr : ColladaDocument::child(*common, "accessor");
  if (accessor == nullptr) {
    document_.faults().error("collada.bad-reference", ColladaDocument::placeOf(source),
                             "<source> lacks an <accessor>");
    return nullptr;
  }
  const std::string_view url = ColladaDocument::attribute(*accessor, "source");
  Element* array = url.starts_with('#') ? document_.find("int_array", url.substr(1)) : nullptr;
  if (array == nullptr) array = document_.follow(*accessor, "source", "float_array");
  if (array == nullptr) return nullptr;
  auto read = std::make_unique<ColladaSource>();
  read->numbers = &numbersOf(*array);
  read->offset = ColladaDocument::numberOf(*accessor, "offset", 0);
  read->stride = std::max<std::uint64_t>(ColladaDocument::numberOf(*accessor, "stride", 1), 1);
  read->count = ColladaDocument::numberOf(*accessor, "count", 0);
  const std::size_t size = read->numbers->size();
  const std::size_t held = read->offset > size ? 0 : (size - read->offset) / read->stride;
  if (read->count > held) {
    document_.faults().error(
        "collada.bad-count", ColladaDocument::placeOf(*accessor),
        fmt::format("an <accessor> reads {} times {} numbers of an array of {}", read->count,
                    read->stride, size));
    read->count = held;
  }
  // Many accessors of one long array would take more memory than a file has bytes.
  if (read->count > kMaxValues - values_) {
    document_.faults().error(
        "collada.bad-count", ColladaDocument::placeOf(*accessor),
        fmt::format("all <accessor>s together read more than {} values", kMaxValues),
        "what this one reads is left out");
    return nullptr;
  }
  values_ += read->count;
  const std::vector<Element*> params = ColladaDocument::children(*accessor, "param");
  read->component = componentsOf(params, read->stride, semantic);
  const std::size_t needed = semantic == "TEXCOORD" ? 2 : 3;
  if (!params.empty() && params.size() < needed && read->stride >= needed) {
    document_.faults().warning("collada.bad-count", ColladaDocument::placeOf(*accessor),
                               fmt::format("an <accessor> of {} names {} of its {} numbers",
                                           semantic, params.size(), read->stride));
  }
  return read;
}

const ColladaSource* ColladaGeometries::source(const ColladaInput& input) {
  ColladaDocument::use(*input.element);
  Element* const source = document_.follow(*input.element, "source", "source");
  if (source == nullptr) return nullptr;
  const auto [found, is_new] = sources_.try_emplace({source, input.semantic});
  if (is_new) found->second = readSource(*source, input.semantic);
  return found->second.get();
}

void ColladaGeometries::readPrimitive(Element& element, std::vector<ColladaPrimitive>& all) {
  ColladaPrimitive primitive;
  primitive.element = &element;
  primitive.material = ColladaDocument::attribute(element, "material");
  std::vector<ColladaInput> of_vertices;
  const auto inputOf = [](Element& input, std::size_t offset) {
    return ColladaInput{&input, ColladaDocument::attribute(input, "semantic"),
                        ColladaDocument::numberOf(input, "set", 0), offset};
  };
  for (Element* each = element.FirstChildElement("input"); each != nullptr;
       each = each->NextSiblingElement("input")) {
    if (primitive.inputs.size() >= kMaxInputs) break;
    const ColladaInput input =
        inputOf(*each, std::min(ColladaDocument::numberOf(*each, "offset", 0), kMaxOffset));
    primitive.stride = std::max(primitive.stride, input.offset + 1);
    if (input.semantic != "VERTEX") {
      primitive.inputs.push_back(input);
      continue;
    }
    ColladaDocument::use(*each);
    Element* const vertices = document_.follow(*each, "source", "vertices");
    if (vertices == nullptr) continue;
    for (Element* inner = vertices->FirstChildElement("input"); inner != nullptr;
         inner = inner->NextSiblingElement("input")) {
      if (of_vertices.size() >= kMaxInputs) break;
      of_vertices.push_back(inputOf(*inner, input.offset));
    }
  }
  primitive.inputs.insert(primitive.inputs.end(), of_vertices.begin(), of_vertices.end());
  const ColladaInput* const points = primitive.input("POSITION");
  if (points == nullptr) {
    document_.faults().error("collada.bad-reference", ColladaDocument::placeOf(element),
                             fmt::format("<{}> has no positions", element.Name()));
    return;
  }
  primitive.positions = source(*points);
  primitive.position_offset = points->offset;
  if (primitive.positions == nullptr) return;
  readColladaPrimitive(document_, element, primitive);
  if (!primitive.corners.empty()) all.push_back(std::move(primitive));
}

const std::vector<ColladaPrimitive>& ColladaGeometries::of(Element& geometry) {
  const auto [found, is_new] = geometries_.try_emplace(&geometry);
  if (!is_new) return found->second;
  Element* mesh = ColladaDocument::child(geometry, "mesh");
  if (mesh == nullptr) mesh = geometry.FirstChildElement("convex_mesh");
  // A hull of another geometry has nothing of its own, and stays in the account.
  if (mesh == nullptr || mesh->FirstChildElement() == nullptr) return found->second;
  ColladaDocument::use(*mesh);
  for (Element* each = mesh->FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    if (!isSurface(each->Name())) continue;
    ColladaDocument::use(*each);
    readPrimitive(*each, found->second);
  }
  return found->second;
}

}  // namespace rocinante
