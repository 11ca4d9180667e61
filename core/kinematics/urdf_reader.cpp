#include "core/kinematics/urdf_reader.h"

#include <fmt/format.h>

#include <string_view>

#include "core/document/fault_list.h"
#include "core/kinematics/model_draft.h"
#include "core/kinematics/urdf_joint.h"
#include "core/kinematics/urdf_link.h"

namespace rocinante {
namespace {

std::string problemOf(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file holds no XML";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "the XML breaks off here: an end tag does not match its start tag";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "the XML is nested deeper than 100 elements";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "the XML breaks off here: an attribute is not NAME=\"VALUE\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "the XML breaks off here: a comment does not end";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "the XML breaks off here: a CDATA section does not end";
    default:
      return "the XML breaks off here: this is not a well-formed element";
  }
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
                 tag == "sdf" ? "this is SDF, which is not read; convert it to URDF" : "");
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
  const std::string_view text = textOf(bytes);
  const XmlPlaces places(text);
  if (places.elementCount() > kMaxUrdfElements) {
    faults.error("urdf.too-many", {},
                 fmt::format("the file has more than {} elements", kMaxUrdfElements));
    return std::nullopt;
  }
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  if (document.Error()) {
    faults.error("urdf.xml", {document.ErrorLineNum(), 0}, problemOf(document.ErrorID()));
    return std::nullopt;
  }
  places.attach(document);
  const tinyxml2::XMLElement* robot = document.RootElement();
  if (robot == nullptr) {
    faults.error("urdf.xml", {}, "the file holds no XML element");
    return std::nullopt;
  }
  if (!isUrdf(*robot, places, faults)) return std::nullopt;

  const UrdfContext context{places, faults};
  const UrdfElement root(*robot, context);
  root.expectChildren({"link", "joint", "material", "transmission", "gazebo", "sensor"});
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
  if (model) judgeScale(*model, links.meshUses(), faults);
  return model;
}

}  // namespace rocinante
