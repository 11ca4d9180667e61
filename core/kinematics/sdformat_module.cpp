#include "core/kinematics/sdformat_module.h"

#include <console_bridge/console.h>

#include <cstdlib>
#include <exception>
#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Collision.hh>
#include <sdf/Console.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Geometry.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/Link.hh>
#include <sdf/Material.hh>
#include <sdf/Mesh.hh>
#include <sdf/Model.hh>
#include <sdf/ParserConfig.hh>
#include <sdf/Root.hh>
#include <sdf/SDFImpl.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>
#include <sdf/World.hh>
#include <string>
#include <utility>

namespace {

RocinanteSdfPose plain(const ignition::math::Pose3d& pose) {
  const auto& p = pose.Pos();
  const auto& q = pose.Rot();
  return {{p.X(), p.Y(), p.Z()}, {q.X(), q.Y(), q.Z(), q.W()}};
}

void tell(const RocinanteSdfSink& sink, const sdf::Errors& errors) {
  bool is_innermost = true;
  for (const sdf::Error& error : errors) {
    // It has the whole file in its text.
    if (error.Code() == sdf::ErrorCode::STRING_READ) continue;
    const std::string text = error.Message();
    // One for the element that it could not read, and one for each above it.
    const bool is_unread = text.rfind("Error reading element", 0) == 0;
    if (is_unread && !is_innermost) continue;
    is_innermost = is_innermost && !is_unread;
    sink.fault(sink.to, error.LineNumber().value_or(0), text.c_str());
  }
}

const char* kindOf(const sdf::Geometry& geometry, double (&size)[3]) {
  switch (geometry.Type()) {
    case sdf::GeometryType::BOX:
      for (std::size_t i = 0; i < 3; ++i) size[i] = geometry.BoxShape()->Size()[i];
      return "box";
    case sdf::GeometryType::SPHERE:
      size[0] = geometry.SphereShape()->Radius();
      return "sphere";
    case sdf::GeometryType::CYLINDER:
      size[0] = geometry.CylinderShape()->Radius();
      size[1] = geometry.CylinderShape()->Length();
      return "cylinder";
    case sdf::GeometryType::CAPSULE:
      size[0] = geometry.CapsuleShape()->Radius();
      size[1] = geometry.CapsuleShape()->Length();
      return "capsule";
    case sdf::GeometryType::MESH:
      for (std::size_t i = 0; i < 3; ++i) size[i] = geometry.MeshShape()->Scale()[i];
      return "mesh";
    case sdf::GeometryType::EMPTY:
      return "empty";
    default:
      return "plane, heightmap or other";
  }
}

RocinanteSdfMaterial plain(const sdf::Material& material, const std::string& script) {
  RocinanteSdfMaterial made{};
  made.script = script.c_str();
  const sdf::ElementPtr element = material.Element();
  const auto set = [&](const char* name, const ignition::math::Color& color, std::int32_t& has,
                       float(&rgba)[4]) {
    has = element != nullptr && element->HasElement(name) ? 1 : 0;
    const float values[] = {color.R(), color.G(), color.B(), color.A()};
    for (int i = 0; i < 4; ++i) rgba[i] = values[i];
  };
  set("ambient", material.Ambient(), made.has_ambient, made.ambient);
  set("diffuse", material.Diffuse(), made.has_diffuse, made.diffuse);
  set("emissive", material.Emissive(), made.has_emissive, made.emissive);
  return made;
}

/// `shape` with what visuals and collisions have in common.
template <class Owner>
void tellShape(const RocinanteSdfSink& sink, const Owner& owner, const sdf::Link& link,
               RocinanteSdfShape shape) {
  const std::string name = owner.Name();
  ignition::math::Pose3d pose;
  tell(sink, owner.SemanticPose().Resolve(pose, link.Name()));
  shape.name = name.c_str();
  shape.in_link = plain(pose);
  shape.line = owner.Element() == nullptr ? 0 : owner.Element()->LineNumber().value_or(0);
  const sdf::Geometry* geometry = owner.Geom();
  if (geometry == nullptr) return;
  shape.kind = kindOf(*geometry, shape.size);
  std::string uri, submesh;
  if (const sdf::Mesh* mesh = geometry->MeshShape()) {
    uri = mesh->Uri();
    submesh = mesh->Submesh();
    shape.center_submesh = mesh->CenterSubmesh() ? 1 : 0;
  }
  shape.uri = uri.c_str();
  shape.submesh = submesh.c_str();
  sink.shape(sink.to, &shape);
}

void tellVisual(const RocinanteSdfSink& sink, const sdf::Visual& visual, const sdf::Link& link) {
  RocinanteSdfShape shape{};
  shape.transparency = visual.Transparency();
  const sdf::Material* const material = visual.Material();
  if (material == nullptr) return tellShape(sink, visual, link, shape);
  const std::string script = material->ScriptName();
  const RocinanteSdfMaterial described = plain(*material, script);
  shape.material = &described;
  tellShape(sink, visual, link, shape);
}

/// A model in the one that is read.
struct Within {
  std::string prefix;  ///< of its names
  ignition::math::Pose3d pose;
};

void tellLink(const RocinanteSdfSink& sink, const sdf::Link& link, const Within& model) {
  ignition::math::Pose3d pose;
  tell(sink, link.SemanticPose().Resolve(pose, "__model__"));
  const RocinanteSdfPose in_model = plain(model.pose * pose);
  const std::string name = model.prefix + link.Name();
  sink.link(sink.to, name.c_str(), &in_model);
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    tellVisual(sink, *link.VisualByIndex(i), link);
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    RocinanteSdfShape shape{};
    shape.is_collision = 1;
    tellShape(sink, *link.CollisionByIndex(i), link, shape);
  }
}

const char* wordOf(sdf::JointType type) {
  switch (type) {
    case sdf::JointType::FIXED:
      return "fixed";
    case sdf::JointType::REVOLUTE:
      return "revolute";
    case sdf::JointType::CONTINUOUS:
      return "continuous";
    case sdf::JointType::PRISMATIC:
      return "prismatic";
    case sdf::JointType::BALL:
      return "ball";
    case sdf::JointType::GEARBOX:
      return "gearbox";
    case sdf::JointType::REVOLUTE2:
      return "revolute2";
    case sdf::JointType::SCREW:
      return "screw";
    case sdf::JointType::UNIVERSAL:
      return "universal";
    default:
      return "unknown";
  }
}

void tellJoint(const RocinanteSdfSink& sink, const sdf::Joint& joint, const Within& model) {
  ignition::math::Pose3d pose;
  tell(sink, joint.SemanticPose().Resolve(pose, "__model__"));
  const std::string name = model.prefix + joint.Name();
  // A parent or child may be a frame that is attached to a link.
  std::string parent, child;
  tell(sink, joint.ResolveParentLink(parent));
  tell(sink, joint.ResolveChildLink(child));
  // What does not resolve is refused by the name that the file has.
  for (auto [link, element] : {std::pair(&parent, "parent"), std::pair(&child, "child")}) {
    if (link->empty() && joint.Element()) *link = joint.Element()->Get<std::string>(element);
  }
  if (parent != "world") parent.insert(0, model.prefix);
  child.insert(0, model.prefix);
  RocinanteSdfJoint described{};
  described.name = name.c_str();
  described.parent = parent.c_str();
  described.child = child.c_str();
  described.type = wordOf(joint.Type());
  described.in_model = plain(model.pose * pose);
  described.axis[2] = 1;
  if (const sdf::JointAxis* axis = joint.Axis(0)) {
    ignition::math::Vector3d along;
    tell(sink, axis->ResolveXyz(along));
    for (std::size_t i = 0; i < 3; ++i) described.axis[i] = along[i];
    described.lower = axis->Lower();
    described.upper = axis->Upper();
    described.velocity = axis->MaxVelocity();
    described.effort = axis->Effort();
  }
  sink.joint(sink.to, &described);
}

void tellModel(const RocinanteSdfSink& sink, const sdf::Model& model, const Within& here) {
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    tellLink(sink, *model.LinkByIndex(i), here);
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    const sdf::Model& inner = *model.ModelByIndex(i);
    ignition::math::Pose3d pose;
    tell(sink, inner.SemanticPose().Resolve(pose, "__model__"));
    tellModel(sink, inner, {here.prefix + inner.Name() + "::", here.pose * pose});
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    tellJoint(sink, *model.JointByIndex(i), here);
  }
}

/// libsdformat opens ~/.sdformat/sdformat.log on first use. A check must not write files that were
/// not asked for, and its home may not be writable. Programs load cells before they start threads
/// that read the environment.
void keepQuiet() {
  const char* const home = std::getenv("HOME");
  const std::string before = home != nullptr ? home : "";
  ::setenv("HOME", "/dev/null", 1);
  sdf::Console::Instance()->SetQuiet(true);
  if (home != nullptr) {
    ::setenv("HOME", before.c_str(), 1);
  } else {
    ::unsetenv("HOME");
  }
}

/// Where SDF fails, libsdformat tries the text as a URDF, through urdfdom, which writes to standard
/// error that it is none: nobody asked. Restores what was there before.
class SilentUrdfdom : public console_bridge::OutputHandler {
 public:
  SilentUrdfdom() { console_bridge::useOutputHandler(this); }
  ~SilentUrdfdom() override { console_bridge::restorePreviousOutputHandler(); }
  SilentUrdfdom(const SilentUrdfdom&) = delete;
  SilentUrdfdom& operator=(const SilentUrdfdom&) = delete;

  void log(const std::string&, console_bridge::LogLevel, const char*, int) override {}
};

void read(const char* text, const RocinanteSdfSink& sink) {
  static const bool is_quiet = (keepQuiet(), true);
  static_cast<void>(is_quiet);
  sdf::ParserConfig config;
  config.SetFindCallback([](const std::string&) { return std::string(); });
  sdf::Root root;
  const SilentUrdfdom urdfdom;
  tell(sink, root.LoadSdfString(text, config));
  bool is_first = true;
  const auto use = [&](const sdf::Model& model) {
    const std::string name = model.Name();
    sink.model(sink.to, name.c_str());
    if (is_first) tellModel(sink, model, {});
    is_first = false;
  };
  if (const sdf::Model* model = root.Model()) use(*model);
  for (std::uint64_t w = 0; w < root.WorldCount(); ++w) {
    const sdf::World& world = *root.WorldByIndex(w);
    for (std::uint64_t i = 0; i < world.ModelCount(); ++i) use(*world.ModelByIndex(i));
  }
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int rocinante_sdf_abi(void) { return ROCINANTE_SDF_ABI; }

__attribute__((visibility("default"))) const char* rocinante_sdf_version(void) {
  static const std::string version = sdf::SDF::Version();
  return version.c_str();
}

__attribute__((visibility("default"))) void rocinante_sdf_read(const char* text,
                                                               const RocinanteSdfSink* sink) {
  try {
    read(text, *sink);
  } catch (const std::exception& fault) {
    sink->fault(sink->to, 0, fault.what());
  }
}

}  // extern "C"
