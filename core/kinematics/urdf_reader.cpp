#include "core/kinematics/urdf_reader.h"

#include <fmt/format.h>

#include <string_view>

#include "core/document/fault_list.h"
#include "core/document/xml_account.h"
#include "core/document/xml_document.h"
#include "core/kinematics/model_draft.h"
#include "core/kinematics/urdf_element.h"

namespace rocinante {
namespace {

// What the readers use (docs/cell-format.md, section "URDF").
const XmlUses& urdfUses() {
  constexpr std::string_view kPhysics = "motion is shown, not simulated";
  constexpr std::string_view kSimulator = "what is for a simulator is not read";
  static const XmlUses uses = {
      {"robot",
       {.children = {"link", "joint", "material"},
        .attributes = {"name", "version"},
        .ignored = {{"transmission", "actuators are not modelled"},
                    {"gazebo", kSimulator},
                    {"sensor", kSimulator}}}},
      {"link",
       {.children = {"visual", "collision"},
        .attributes = {"name"},
        .ignored = {{"inertial", "masses are not used"}}}},
      {"visual", {.children = {"origin", "geometry", "material"}, .attributes = {"name"}}},
      {"collision",
       {.children = {"origin", "geometry"},
        .attributes = {"name"},
        .ignored = {{"material", "collision geometry has one colour"}}}},
      {"geometry", {.children = {"box", "cylinder", "sphere", "capsule", "mesh"}}},
      {"box", {.attributes = {"size"}}},
      {"sphere", {.attributes = {"radius"}}},
      {"cylinder", {.attributes = {"radius", "length"}}},
      {"capsule", {.attributes = {"radius", "length"}}},
      {"mesh", {.attributes = {"filename", "scale"}}},
      {"material", {.children = {"color", "texture"}, .attributes = {"name"}}},
      {"color", {.attributes = {"rgba"}}},
      {"texture", {.attributes = {"filename"}}},
      {"origin", {.attributes = {"xyz", "rpy", "quat_xyzw"}}},
      {"joint",
       {.children = {"origin", "parent", "child", "axis", "limit", "mimic"},
        .attributes = {"name", "type"},
        .ignored = {{"calibration", kPhysics},
                    {"dynamics", kPhysics},
                    {"safety_controller", kPhysics},
                    {"joint_properties", kPhysics}}}},
      {"parent", {.attributes = {"link"}}},
      {"child", {.attributes = {"link"}}},
      {"axis", {.attributes = {"xyz"}}},
      {"limit", {.attributes = {"lower", "upper", "effort", "velocity"}}},
      {"mimic", {.attributes = {"joint", "multiplier", "offset"}}}};
  return uses;
}

// The first xacro element, which no URDF reader understands.
const tinyxml2::XMLElement* xacroElement(const tinyxml2::XMLElement& robot) {
  const tinyxml2::XMLElement* element = &robot;
  while (element != nullptr) {
    if (std::string_view(element->Name()).starts_with("xacro:")) return element;
    const tinyxml2::XMLElement* next = element->FirstChildElement();
    while (next == nullptr && element != nullptr && element != &robot) {
      next = element->NextSiblingElement();
      element = element->Parent()->ToElement();
    }
    element = next;
  }
  return nullptr;
}

// The meshes of its visuals and collisions.
std::vector<MeshWanted> meshesOf(const tinyxml2::XMLElement& robot,
                                 const std::filesystem::path& folder) {
  std::vector<MeshWanted> wanted;
  for (const auto* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (const auto* part = link->FirstChildElement(); part != nullptr;
         part = part->NextSiblingElement()) {
      const tinyxml2::XMLElement* geometry = part->FirstChildElement("geometry");
      const auto* mesh = geometry == nullptr ? nullptr : geometry->FirstChildElement("mesh");
      const char* name = mesh == nullptr ? nullptr : mesh->Attribute("filename");
      if (name != nullptr) wanted.push_back({name, folder});
    }
  }
  return wanted;
}

// Whether reading can continue with the links.
bool isUrdf(const tinyxml2::XMLElement& robot, const XmlPlaces& places, FaultList& faults) {
  const std::string_view tag = robot.Name();
  if (tag != "robot") {
    faults.error("urdf.no-robot", places.of(robot),
                 fmt::format("the outermost element is <{}>, where URDF has <robot>",
                             std::string(tag.substr(0, 60))),
                 tag == "sdf" ? "this is SDF: name the file .sdf" : "");
    return false;
  }
  if (const tinyxml2::XMLElement* xacro = xacroElement(robot)) {
    faults.error("urdf.xacro", places.of(*xacro),
                 fmt::format("<{}> makes this a xacro template, not URDF",
                             std::string(std::string_view(xacro->Name()).substr(0, 60))),
                 "expand the template first: xacro model.xacro > model.urdf");
    return false;
  }
  return true;
}

}  // namespace

std::optional<Model> readUrdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                              Findings& all_faults) {
  FaultList faults(all_faults, path.string());
  if (bytes.size() > kMaxUrdfBytes) {
    faults.error("urdf.too-large", {},
                 fmt::format("the file is larger than {} MiB", kMaxUrdfBytes >> 20));
    return std::nullopt;
  }
  const auto document =
      XmlDocument::parse(bytes, kMaxUrdfElements, {"urdf.xml", "urdf.too-many"}, faults);
  if (!document) return std::nullopt;
  const XmlPlaces& places = document->places();
  const tinyxml2::XMLElement* const robot = &document->root();
  if (!isUrdf(*robot, places, faults)) return std::nullopt;

  const UrdfContext context{places, faults};
  const UrdfElement root(*robot, context);
  ModelDraft draft;
  draft.rules = "urdf";
  draft.file = path.string();
  draft.place = root.place();
  draft.name = root.text("name");
  if (draft.name.empty()) {
    draft.name = path.stem().string();
    faults.warning("urdf.no-name", root.place(), "<robot> has no name",
                   "URDF requires one; other readers refuse the file");
  }

  meshes.readAhead(meshesOf(*robot, path.parent_path()));
  UrdfLinkReader links(meshes, path.parent_path());
  root.each("material", [&](const UrdfElement& below) { links.addMaterial(below); });
  std::size_t link_count = 0, joint_count = 0;
  root.each("link", [&](const UrdfElement&) { ++link_count; });
  root.each("joint", [&](const UrdfElement&) { ++joint_count; });
  if (link_count > kMaxLinks || joint_count > kMaxLinks) {
    faults.error("urdf.too-many", root.place(),
                 fmt::format("the robot has more than {} links or joints", kMaxLinks));
    return std::nullopt;
  }
  root.each("link", [&](const UrdfElement& below) {
    if (auto link = links.readLink(below)) draft.links.push_back(std::move(*link));
  });
  root.each("joint", [&](const UrdfElement& below) {
    if (auto joint = readUrdfJoint(below)) draft.joints.push_back(std::move(*joint));
  });
  links.resolveMaterials(draft.links, faults);
  auto model = finishModel(std::move(draft), faults);
  accountForXml(*robot, places, urdfUses(), "urdf.unknown-element", faults);
  if (!model) return model;
  judgeScale(*model, links.meshUses(), faults);
  judgeVisibility(*model, root.place(), faults);
  return model;
}

}  // namespace rocinante
