#include "core/mesh/collada_document.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

#include "core/document/xml_document.h"
#include "core/document/xml_tags.h"

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

constexpr std::size_t kDeepestElement = 100;     // elements in elements
constexpr std::ptrdiff_t kMaxTags = 20'000'000;  // start and end tags; attributes likewise

struct ColladaReason {
  std::string_view name;
  std::string_view text;
  Severity severity = Severity::note;
};

constexpr std::string_view kUnused = "nothing that is drawn uses it";
constexpr std::string_view kPhysics = "physics is not read";
constexpr std::string_view kKinematics = "joints are read from URDF and SDF only";

/// Why elements are not used, by name.
constexpr std::array kColladaReasons = {
    ColladaReason{"animation", "animations are not played"},
    ColladaReason{"animation_clip", "animations are not played"},
    ColladaReason{"articulated_system", kKinematics},
    ColladaReason{"formula", kKinematics},
    ColladaReason{"instance_kinematics_scene", kKinematics},
    ColladaReason{"joint", kKinematics},
    ColladaReason{"kinematics_model", kKinematics},
    ColladaReason{"kinematics_scene", kKinematics},
    ColladaReason{"force_field", kPhysics},
    ColladaReason{"instance_physics_scene", kPhysics},
    ColladaReason{"physics_material", kPhysics},
    ColladaReason{"physics_model", kPhysics},
    ColladaReason{"physics_scene", kPhysics},
    ColladaReason{"camera", "cameras of meshes are not used"},
    ColladaReason{"instance_camera", "cameras of meshes are not used"},
    ColladaReason{"light", "lights of meshes are not used"},
    ColladaReason{"instance_light", "lights of meshes are not used"},
    ColladaReason{"skin", "the mesh is drawn as modelled, not bent by its skeleton"},
    ColladaReason{"morph", "the mesh is drawn without its morph targets"},
    ColladaReason{"lines", "lines are not drawn"},
    ColladaReason{"linestrips", "lines are not drawn"},
    ColladaReason{"spline", "curves are not drawn"},
    ColladaReason{"brep", "curved surfaces are not drawn"},
    ColladaReason{"convex_mesh", "convex hulls are not drawn", Severity::warning},
    ColladaReason{"ambient", "the light around is the renderer's"},
    ColladaReason{"reflective", "reflections are not drawn"},
    ColladaReason{"reflectivity", "reflections are not drawn"},
    ColladaReason{"index_of_refraction", "refraction is not drawn"},
    ColladaReason{"texture", "only the image of <diffuse> is drawn"},
    ColladaReason{"controller", kUnused},
    ColladaReason{"effect", kUnused},
    ColladaReason{"geometry", kUnused},
    ColladaReason{"image", kUnused},
    ColladaReason{"input", kUnused},
    ColladaReason{"instance_material", kUnused},
    ColladaReason{"material", kUnused},
    ColladaReason{"newparam", kUnused},
    ColladaReason{"node", kUnused},
    ColladaReason{"source", kUnused},
    ColladaReason{"vertices", kUnused},
    ColladaReason{"visual_scene", kUnused},
};

/// Attributes that are read, or that change nothing in a picture.
constexpr std::string_view kKnownAttributes[] = {"id",           "name",           "sid",
                                                 "url",          "source",         "count",
                                                 "stride",       "offset",         "set",
                                                 "semantic",     "type",           "material",
                                                 "symbol",       "target",         "texture",
                                                 "texcoord",     "opaque",         "meter",
                                                 "ref",          "input_semantic", "input_set",
                                                 "digits",       "magnitude",      "version",
                                                 "xmlns",        "layer",          "mip",
                                                 "slice",        "face",           "minInclusive",
                                                 "maxInclusive", "profile",        "convex_hull_of",
                                                 "base"};

/// The words of an element's text; a comment or CDATA within it separates words, as a blank does.
template <class Take>
void forEachWord(const Element& element, const Take& take) {
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr;
       node = node->NextSibling()) {
    if (node->ToText() == nullptr) continue;
    const char* at = node->Value();
    while (*at != '\0') {
      if (static_cast<unsigned char>(*at) <= ' ') {
        ++at;
        continue;
      }
      const char* const from = at;
      while (static_cast<unsigned char>(*at) > ' ') ++at;
      take(from, at);
    }
  }
}

}  // namespace

std::size_t ColladaDocument::HashOfKey::operator()(const Key& key) const {
  const std::hash<std::string_view> hash;
  return hash(key.id) * 31 + hash(key.name);
}

Status ColladaDocument::parse(ByteView bytes) {
  const auto damaged = [](std::string what) {
    return Error{ErrorKind::damaged, std::move(what), {}};
  };
  if (textOf(bytes).starts_with("PK")) {
    return damaged("is a ZIP file; unpack it and name the .dae inside");
  }
  std::string problem;
  const std::string text = xmlAsUtf8(textOf(bytes), problem);
  if (!problem.empty()) return damaged(std::move(problem));
  // Each tag takes a hundred bytes of memory, of which the file needs four.
  if (std::ranges::count(text, '<') > kMaxTags || std::ranges::count(text, '=') > kMaxTags) {
    return damaged(fmt::format("has more than {} tags", kMaxTags));
  }
  switch (xml_.Parse(text.data(), text.size())) {
    case tinyxml2::XML_SUCCESS:
      break;
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return damaged(fmt::format("the XML is nested deeper than {} elements", kDeepestElement));
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return damaged("holds no XML");
    default:
      return damaged(fmt::format("the XML breaks off in line {}", xml_.ErrorLineNum()));
  }
  if (xml_.RootElement() == nullptr || std::string_view(root().Name()) != "COLLADA") {
    return damaged("is not COLLADA: its outermost element is not <COLLADA>");
  }
  use(root());
  return index();
}

Status ColladaDocument::index() {
  std::size_t depth = 1;
  for (Element* element = &root(); element != nullptr;) {
    if (const std::string_view id = attribute(*element, "id"); !id.empty()) {
      ids_.emplace(Key{element->Name(), id}, element);
    }
    Element* next = element->FirstChildElement();
    if (next != nullptr && ++depth > kDeepestElement) {
      return Error{ErrorKind::damaged,
                   fmt::format("the XML is nested deeper than {} elements", kDeepestElement),
                   {}};
    }
    while (next == nullptr && element != &root()) {
      next = element->NextSiblingElement();
      if (next != nullptr) break;
      element = element->Parent()->ToElement();
      --depth;
    }
    element = next;
  }
  return {};
}

Element* ColladaDocument::child(Element& parent, const char* name) {
  Element* const found = parent.FirstChildElement(name);
  if (found != nullptr) use(*found);
  return found;
}

std::vector<Element*> ColladaDocument::children(Element& parent, const char* name) {
  std::vector<Element*> found;
  for (Element* each = parent.FirstChildElement(name); each != nullptr;
       each = each->NextSiblingElement(name)) {
    use(*each);
    found.push_back(each);
  }
  return found;
}

Element* ColladaDocument::find(std::string_view name, std::string_view id) const {
  const auto found = ids_.find(Key{name, id});
  if (found == ids_.end()) return nullptr;
  use(*found->second);
  return found->second;
}

Element* ColladaDocument::follow(const Element& from, const char* attribute, const char* name) {
  const std::string_view url = ColladaDocument::attribute(from, attribute);
  Element* const found = url.starts_with('#') ? find(name, url.substr(1)) : nullptr;
  if (found != nullptr) return found;
  const bool is_elsewhere = url.find('#') != std::string_view::npos && !url.starts_with('#');
  faults_.warning("collada.bad-reference", placeOf(from),
                  is_elsewhere ? fmt::format("<{}> refers to another file, {}, which is not read",
                                             from.Name(), quotedPathInFault(url))
                               : fmt::format("<{}> refers to {}, but the file has no such <{}>",
                                             from.Name(), quotedInFault(url), name));
  return nullptr;
}

std::string_view ColladaDocument::attribute(const Element& element, const char* name) {
  const char* const value = element.Attribute(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::uint64_t ColladaDocument::numberOf(const Element& element, const char* name,
                                        std::uint64_t otherwise) {
  std::string_view text = attribute(element, name);
  text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() ? number : otherwise;
}

std::string ColladaDocument::text(const Element& element) {
  std::string text;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr;
       node = node->NextSibling()) {
    if (node->ToText() != nullptr) text += node->Value();
  }
  text.erase(text.find_last_not_of(kXmlBlanks) + 1);
  text.erase(0, std::min(text.find_first_not_of(kXmlBlanks), text.size()));
  return text;
}

void ColladaDocument::badNumber(const Element& element, std::string_view word) {
  faults_.error("collada.bad-value", placeOf(element),
                fmt::format("<{}> needs numbers, not {}", element.Name(), quotedInFault(word)));
}

std::vector<double> ColladaDocument::numbers(const Element& element) {
  std::vector<double> numbers;
  forEachWord(element, [&](const char* from, const char* to) {
    double number = std::numeric_limits<double>::quiet_NaN();
    const auto read = fast_float::from_chars(*from == '+' ? from + 1 : from, to, number);
    if (read.ptr != to) {
      number = std::numeric_limits<double>::quiet_NaN();
      badNumber(element, {from, static_cast<std::size_t>(to - from)});
    }
    numbers.push_back(number);
  });
  return numbers;
}

std::vector<double> ColladaDocument::numbers(const Element& element, std::size_t count) {
  std::vector<double> given = numbers(element);
  const bool finite = std::ranges::all_of(given, [](double each) { return std::isfinite(each); });
  if (finite && given.size() == count) return given;
  faults_.error("collada.bad-value", placeOf(element),
                fmt::format("<{}> needs {} finite numbers and has {}", element.Name(), count,
                            finite ? fmt::format("{}", given.size()) : "others"));
  return {};
}

void ColladaDocument::addIndices(const Element& element, std::vector<std::uint32_t>& indices) {
  forEachWord(element, [&](const char* from, const char* to) {
    std::uint32_t index = kBadIndex;
    const auto read = std::from_chars(*from == '+' ? from + 1 : from, to, index);
    if (read.ec != std::errc() || read.ptr != to) {
      index = kBadIndex;
      badNumber(element, {from, static_cast<std::size_t>(to - from)});
    }
    indices.push_back(index);
  });
}

void ColladaDocument::leaveOut(const Element& element) {
  const std::string_view name = element.Name();
  const Place place = placeOf(element);
  // Who made it, and when.
  static constexpr std::string_view kMetadata[] = {"contributor", "coverage", "created", "keywords",
                                                   "modified",    "revision", "subject", "title"};
  const auto* const above = element.Parent()->ToElement();
  if (above != nullptr && std::string_view(above->Name()) == "asset" &&
      std::ranges::find(kMetadata, name) != std::end(kMetadata)) {
    return;
  }
  if (name == "asset") {
    for (const char* each : {"unit", "up_axis"}) {
      const Element* const own = element.FirstChildElement(each);
      if (own == nullptr) continue;
      faults_.leaveOut("element", each, placeOf(*own), "only that of the whole file is used",
                       Severity::warning);
    }
    return;
  }
  if (name == "instance_camera" || name == "instance_light") {
    // Named where it is defined, if it is.
    const std::string_view url = attribute(element, "url");
    if (url.starts_with('#') && ids_.contains(Key{name.substr(9), url.substr(1)})) return;
  }
  if (name == "extra" || name == "technique") {
    const Element* const inner =
        name == "extra" ? element.FirstChildElement("technique") : &element;
    return faults_.leaveOut("extension", inner == nullptr ? name : attribute(*inner, "profile"),
                            place, "what programs add to COLLADA for themselves is not read");
  }
  const auto* const reason = std::ranges::find(kColladaReasons, name, &ColladaReason::name);
  std::string what(name);
  if (name == "input") what += " " + std::string(attribute(element, "semantic"));
  if (reason != kColladaReasons.end()) {
    return faults_.leaveOut("element", what, place, std::string(reason->text), reason->severity);
  }
  faults_.leaveOut("element", what, place, "it is not read here");
}

void ColladaDocument::leaveOutAttributes(const Element& element) {
  for (const tinyxml2::XMLAttribute* each = element.FirstAttribute(); each != nullptr;
       each = each->Next()) {
    const std::string_view name = each->Name();
    if (name.find(':') != std::string_view::npos) continue;  // xsi:type, xmlns:math
    if (std::ranges::find(kKnownAttributes, name) != std::end(kKnownAttributes)) continue;
    faults_.leaveOut("attribute", name, {each->GetLineNum(), 0}, "it is not read");
  }
}

void ColladaDocument::accountForRest() {
  for (Element* element = &root(); element != nullptr;) {
    const bool is_library = std::string_view(element->Name()).starts_with("library_");
    Element* next = nullptr;
    if (element->GetUserData() != nullptr || is_library) {
      leaveOutAttributes(*element);
      next = element->FirstChildElement();
    } else {
      leaveOut(*element);
    }
    while (next == nullptr && element != &root()) {
      next = element->NextSiblingElement();
      if (next == nullptr) element = element->Parent()->ToElement();
    }
    element = next;
  }
}

}  // namespace rocinante
