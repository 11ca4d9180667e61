#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/document/xml_account.h"
#include "core/document/xml_tags.h"
#include "core/kinematics/sdf_reader.h"
#include "core/kinematics/visual_materials.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxSdfNumbers = 16;  // of one element
constexpr double kLeastGround_m = 10;

// What the reader uses (docs/meshes.md, section "SDF").
const XmlUses& sdfUses() {
  constexpr std::string_view kPhysics = "motion is shown, not simulated";
  constexpr std::string_view kSimulator = "what is for a simulator is not read";
  constexpr std::string_view kWorld = "of a world only its models are read";
  constexpr std::string_view kShape = "a shape that is not drawn";
  constexpr std::string_view kSurface = "a property of the surface that is not drawn";
  constexpr std::string_view kAxis = "joints with two axes are not read";
  static const XmlUses uses = {
      {"sdf",
       {.children = {"model", "world"},
        .attributes = {"version"},
        .ignored = {{"light", kWorld}, {"actor", kWorld}}}},
      {"world",
       {.children = {"model", "frame"},
        .attributes = {"name"},
        .ignored = {{"light", kWorld},
                    {"actor", kWorld},
                    {"physics", kPhysics},
                    {"gravity", kPhysics},
                    {"wind", kPhysics},
                    {"atmosphere", kPhysics},
                    {"magnetic_field", kPhysics},
                    {"audio", kSimulator},
                    {"gui", kSimulator},
                    {"plugin", kSimulator},
                    {"population", kSimulator},
                    {"road", kWorld},
                    {"scene", kWorld},
                    {"spherical_coordinates", kSimulator},
                    {"state", kSimulator}}}},
      {"model",
       {.children = {"link", "joint", "frame", "model", "pose"},
        .attributes = {"name", "canonical_link", "placement_frame"},
        .ignored = {{"static", kPhysics},
                    {"self_collide", kPhysics},
                    {"allow_auto_disable", kPhysics},
                    {"enable_wind", kPhysics},
                    {"gripper", kSimulator},
                    {"plugin", kSimulator}}}},
      {"frame", {.children = {"pose"}, .attributes = {"name", "attached_to"}}},
      {"pose", {.attributes = {"relative_to", "rotation_format", "degrees", "frame"}}},
      {"link",
       {.children = {"pose", "visual", "collision"},
        .attributes = {"name"},
        .ignored = {{"inertial", "masses are not used"},
                    {"sensor", kSimulator},
                    {"light", "lamps of a model are not lit"},
                    {"particle_emitter", kSimulator},
                    {"projector", kSimulator},
                    {"audio_source", kSimulator},
                    {"audio_sink", kSimulator},
                    {"battery", kSimulator},
                    {"plugin", kSimulator},
                    {"gravity", kPhysics},
                    {"enable_wind", kPhysics},
                    {"self_collide", kPhysics},
                    {"kinematic", kPhysics},
                    {"must_be_base_link", kPhysics},
                    {"velocity_decay", kPhysics}}}},
      {"visual",
       {.children = {"pose", "geometry", "material", "transparency"},
        .attributes = {"name"},
        .ignored = {{"cast_shadows", kSurface},
                    {"laser_retro", kSimulator},
                    {"visibility_flags", kSimulator},
                    {"meta", kSimulator},
                    {"plugin", kSimulator}}}},
      {"collision",
       {.children = {"pose", "geometry"},
        .attributes = {"name"},
        .ignored = {{"surface", kPhysics},
                    {"laser_retro", kSimulator},
                    {"max_contacts", kPhysics}}}},
      {"geometry",
       {.children = {"box", "sphere", "cylinder", "capsule", "mesh", "empty"},
        .ignored = {{"plane", kShape},
                    {"ellipsoid", kShape},
                    {"heightmap", kShape},
                    {"image", kShape},
                    {"cone", kShape},
                    {"polyline", kShape}}}},
      {"box", {.children = {"size"}}},
      {"sphere", {.children = {"radius"}}},
      {"cylinder", {.children = {"radius", "length"}}},
      {"capsule", {.children = {"radius", "length"}}},
      {"mesh", {.children = {"uri", "scale", "submesh"}}},
      {"submesh", {.children = {"name", "center"}}},
      {"material",
       {.children = {"ambient", "diffuse", "emissive", "script"},
        .ignored = {{"specular", kSurface},
                    {"shininess", kSurface},
                    {"pbr", "maps of <pbr> are not drawn"},
                    {"shader", kSurface},
                    {"lighting", kSurface},
                    {"render_order", kSurface},
                    {"double_sided", kSurface}}}},
      {"script", {.children = {"uri", "name"}}},
      {"joint",
       {.children = {"pose", "parent", "child", "axis"},
        .attributes = {"name", "type"},
        .ignored = {{"axis2", kAxis},
                    {"physics", kPhysics},
                    {"sensor", kSimulator},
                    {"thread_pitch", kAxis},
                    {"screw_thread_pitch", kAxis},
                    {"gearbox_ratio", kAxis},
                    {"gearbox_reference_body", kAxis}}}},
      {"axis",
       {.children = {"xyz", "limit", "use_parent_model_frame"},  // the last until SDF 1.6
        .ignored = {{"dynamics", kPhysics},
                    {"initial_position", "a model is read at zero joints"},
                    {"mimic", "libsdformat 12 does not read it: the joint is driven"}}}},
      {"xyz", {.attributes = {"expressed_in"}}},
      {"limit",
       {.children = {"lower", "upper", "effort", "velocity"},
        .ignored = {{"stiffness", kPhysics}, {"dissipation", kPhysics}}}}};
  return uses;
}

/// Values of an element that is read.
struct ValueKind {
  std::string_view tag;
  std::size_t least, most;
  bool is_color = false;
};
constexpr ValueKind kValues[] = {
    {"pose", 6, 6},           {"size", 3, 3},          {"radius", 1, 1},
    {"length", 1, 1},         {"scale", 3, 3},         {"xyz", 3, 3},
    {"lower", 1, 1},          {"upper", 1, 1},         {"effort", 1, 1},
    {"velocity", 1, 1},       {"ambient", 3, 4, true}, {"diffuse", 3, 4, true},
    {"emissive", 3, 4, true}, {"transparency", 1, 1}};

std::string_view textOfElement(const tinyxml2::XMLElement& element) {
  const char* const text = element.GetText();
  std::string_view inner = text == nullptr ? std::string_view() : text;
  const std::size_t first = std::min(inner.find_first_not_of(kXmlBlanks), inner.size());
  inner.remove_prefix(first);
  return inner.substr(0, inner.find_last_not_of(kXmlBlanks) + 1);
}

/// The numbers of a text; empty where a word is none, or there are more than any element takes.
std::optional<std::vector<double>> numbersOfSdf(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = text.find_first_not_of(kXmlBlanks, at)) < text.size();) {
    const std::size_t end = std::min(text.find_first_of(kXmlBlanks, at), text.size());
    std::string_view word = text.substr(at, end - at);
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const auto [behind, error] =
        std::from_chars(word.data(), word.data() + word.size(), numbers.emplace_back());
    if (error != std::errc{} || behind != word.data() + word.size() ||
        numbers.size() > kMaxSdfNumbers) {
      return std::nullopt;
    }
    at = end;
  }
  return numbers;
}

/// A <plane> that lies level and is large: the floor of a world, where others are markers and
/// pictures.
bool isGround(const tinyxml2::XMLElement& shape) {
  if (std::string_view(shape.Name()) != "plane") return false;
  const auto numbersBelow = [&](const char* name, std::vector<double> otherwise) {
    const auto* const given = shape.FirstChildElement(name);
    return given == nullptr ? otherwise : numbersOfSdf(textOfElement(*given)).value_or(otherwise);
  };
  const std::vector<double> normal = numbersBelow("normal", {0, 0, 1});
  const std::vector<double> size = numbersBelow("size", {1, 1});
  return normal.size() == 3 && normal[0] == 0 && normal[1] == 0 && size.size() == 2 &&
         std::min(size[0], size[1]) >= kLeastGround_m;
}

/// The image of a <pbr> material, of either workflow.
const tinyxml2::XMLElement* albedoMapOf(const tinyxml2::XMLElement& material) {
  const auto* const pbr = material.FirstChildElement("pbr");
  if (pbr == nullptr) return nullptr;
  for (const char* workflow : {"metal", "specular"}) {
    const auto* const surface = pbr->FirstChildElement(workflow);
    const auto* const map = surface == nullptr ? nullptr : surface->FirstChildElement("albedo_map");
    if (map != nullptr && !textOfElement(*map).empty()) return map;
  }
  return nullptr;
}

class SdfJudge {
 public:
  SdfJudge(const XmlPlaces& places, FaultList& faults) : places_(places), faults_(faults) {}

  /// False: nothing below the element counts.
  bool visit(const tinyxml2::XMLElement& element) {
    const std::string_view tag = element.Name();
    const auto* const value =
        std::ranges::find(kValues, tag, [](const ValueKind& kind) { return kind.tag; });
    if (value != std::end(kValues)) judgeValue(element, *value);
    if (tag == "model" && isFurther(element)) return false;
    if (tag == "material") judgeMaterial(element);
    if (tag == "geometry" && leavesOutShape(element)) return false;
    return tag != "script";
  }
  bool isSound() const { return sound_; }

 private:
  void judgeValue(const tinyxml2::XMLElement& element, const ValueKind& kind) {
    const std::string_view text = textOfElement(element);
    ValueKind wanted = kind;
    if (kind.tag == "pose") {
      if (text.empty()) return;  // no pose
      const char* const format = element.Attribute("rotation_format");
      if (format != nullptr && std::string_view(format) == "quat_xyzw")
        wanted.least = wanted.most = 7;
    }
    const auto numbers = numbersOfSdf(text);
    const auto isInRange = [&](double number) {
      return !kind.is_color || (number >= 0 && number <= 1);
    };
    if (numbers && numbers->size() >= wanted.least && numbers->size() <= wanted.most &&
        std::ranges::all_of(*numbers, isInRange)) {
      return;
    }
    sound_ = false;
    std::string expected = wanted.most == 1 ? "a number is"
                           : wanted.least == wanted.most
                               ? fmt::format("{} numbers are", wanted.most)
                               : fmt::format("{} or {} numbers", wanted.least, wanted.most);
    if (kind.is_color) expected += " from 0 to 1 are";
    faults_.error(
        "sdf.invalid", places_.of(element),
        fmt::format("<{}> is {}, where {} expected", kind.tag, quotedInFault(text), expected));
  }

  /// Only the first model of the file is read, with the models inside it.
  bool isFurther(const tinyxml2::XMLElement& model) {
    const auto* const above = model.Parent()->ToElement();
    if (above == nullptr || std::string_view(above->Name()) == "model") return false;
    if (!has_model_) {
      has_model_ = true;
      return false;
    }
    const char* const name = model.Attribute("name");
    faults_.leaveOut("model", name == nullptr ? "" : name, places_.of(model),
                     "of several models in a file the first is read", Severity::warning,
                     "sdf.passed-over");
    return true;
  }

  /// A visual's shape that is not drawn is missed in the picture, unless it is the ground. False:
  /// its shape is another one.
  bool leavesOutShape(const tinyxml2::XMLElement& geometry) {
    const auto* const above = geometry.Parent()->ToElement();
    const auto* const shape = geometry.FirstChildElement();
    if (above == nullptr || shape == nullptr || std::string_view(above->Name()) != "visual") {
      return false;
    }
    if (!sdfUses().at("geometry").ignored.contains(shape->Name()) || isGround(*shape)) return false;
    faults_.leaveOut("shape", shape->Name(), places_.of(*shape), "its visual is not drawn",
                     Severity::warning);
    return true;
  }

  /// Of <diffuse>, <script> and <ambient> the first one is drawn.
  void judgeMaterial(const tinyxml2::XMLElement& material) {
    const auto* const diffuse = material.FirstChildElement("diffuse");
    const auto* const ambient = material.FirstChildElement("ambient");
    const auto* const script = material.FirstChildElement("script");
    const std::string_view drawn = diffuse != nullptr                                  ? "diffuse"
                                   : script != nullptr && gazeboColor(nameOf(*script)) ? "script"
                                                                                       : "ambient";
    const auto leaveOut = [&](const tinyxml2::XMLElement& element) {
      faults_.leaveOut("element", element.Name(), places_.of(element),
                       fmt::format("<{}> is drawn", drawn));
    };
    if (ambient != nullptr && drawn != "ambient") leaveOut(*ambient);
    if (const auto* const map = albedoMapOf(material)) {
      faults_.leaveOut("element", map->Name(), places_.of(*map),
                       "the image of a <pbr> surface is not drawn", Severity::warning);
    }
    if (script == nullptr || drawn == "script") return;
    if (gazeboColor(nameOf(*script))) return leaveOut(*script);
    faults_.leaveOut("script", nameOf(*script), places_.of(*script),
                     "of material scripts only the plain colours of Gazebo are known",
                     drawn == "diffuse" ? Severity::note : Severity::warning);
  }

  static std::string_view nameOf(const tinyxml2::XMLElement& script) {
    const auto* const name = script.FirstChildElement("name");
    return name == nullptr ? std::string_view() : textOfElement(*name);
  }

  const XmlPlaces& places_;
  FaultList& faults_;
  bool sound_ = true, has_model_ = false;
};

}  // namespace

bool judgeSdf(const XmlDocument& document, FaultList& faults) {
  const tinyxml2::XMLElement& root = document.root();
  const char* const version = root.Attribute("version");
  if (version == nullptr || *version == '\0') {
    faults.error("sdf.invalid", document.places().of(root), "<sdf> lacks its attribute `version`",
                 "write the version of the format, such as version=\"1.7\"");
  }
  SdfJudge judge(document.places(), faults);
  accountForXml(root, document.places(), sdfUses(), "sdf.unknown-element", faults,
                [&](const tinyxml2::XMLElement& element) { return judge.visit(element); });
  return judge.isSound() && version != nullptr && *version != '\0';
}

}  // namespace rocinante
