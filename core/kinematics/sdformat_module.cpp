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
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>
#include <sdf/World.hh>
#include <string>

namespace {

RocinanteSdfPose plain(const ignition::math::Pose3d& pose) {
  const auto& p = pose.Pos();
  const auto& q = pose.Rot();
  return {{p.X(), p.Y(), p.Z()}, {q.X(), q.Y(), q.Z(), q.W()}};
}

void tell(const RocinanteSdfSink& sink, const sdf::Errors& errors) {
  for (const sdf::Error& error : errors) {
    const std::string text = error.Message();
    sink.fault(sink.to, 1, error.LineNumber().value_or(0), text.c_str());
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

template <class Owner>
void tellShape(const RocinanteSdfSink& sink, const Owner& owner, const sdf::Link& link,
               bool is_collision, const sdf::Material* material) {
  const std::string name = owner.Name();
  ignition::math::Pose3d pose;
  tell(sink, owner.SemanticPose().Resolve(pose, link.Name()));
  RocinanteSdfShape shape{};
  shape.is_collision = is_collision ? 1 : 0;
  shape.name = name.c_str();
  shape.in_link = plain(pose);
  const sdf::Geometry* geometry = owner.Geom();
  if (geometry == nullptr) return;
  shape.kind = kindOf(*geometry, shape.size);
  std::string uri;
  if (geometry->MeshShape() != nullptr) uri = geometry->MeshShape()->Uri();
  shape.uri = uri.c_str();
  if (material != nullptr) {
    const ignition::math::Color& color = material->Diffuse();
    shape.has_color = 1;
    const float rgba[] = {color.R(), color.G(), color.B(), color.A()};
    for (int i = 0; i < 4; ++i) shape.color[i] = rgba[i];
  }
  sink.shape(sink.to, &shape);
}

void tellLink(const RocinanteSdfSink& sink, const sdf::Link& link) {
  ignition::math::Pose3d pose;
  tell(sink, link.SemanticPose().Resolve(pose, "__model__"));
  const RocinanteSdfPose in_model = plain(pose);
  const std::string name = link.Name();
  sink.link(sink.to, name.c_str(), &in_model);
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Visual& visual = *link.VisualByIndex(i);
    tellShape(sink, visual, link, false, visual.Material());
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    tellShape(sink, *link.CollisionByIndex(i), link, true, nullptr);
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

void tellJoint(const RocinanteSdfSink& sink, const sdf::Joint& joint) {
  ignition::math::Pose3d pose;
  tell(sink, joint.SemanticPose().Resolve(pose, "__model__"));
  const std::string name = joint.Name();
  // A parent or child may be a frame that is attached to a link.
  std::string parent, child;
  tell(sink, joint.ResolveParentLink(parent));
  tell(sink, joint.ResolveChildLink(child));
  RocinanteSdfJoint told{};
  told.name = name.c_str();
  told.parent = parent.c_str();
  told.child = child.c_str();
  told.type = wordOf(joint.Type());
  told.in_model = plain(pose);
  told.axis[2] = 1;
  if (const sdf::JointAxis* axis = joint.Axis(0)) {
    ignition::math::Vector3d along;
    tell(sink, axis->ResolveXyz(along));
    for (std::size_t i = 0; i < 3; ++i) told.axis[i] = along[i];
    told.lower = axis->Lower();
    told.upper = axis->Upper();
    told.velocity = axis->MaxVelocity();
    told.effort = axis->Effort();
  }
  sink.joint(sink.to, &told);
}

void tellModel(const RocinanteSdfSink& sink, const sdf::Model& model) {
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) tellLink(sink, *model.LinkByIndex(i));
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) tellJoint(sink, *model.JointByIndex(i));
  if (model.ModelCount() > 0) {
    sink.fault(sink.to, 0, 0, "models inside the model are passed over");
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

/// libsdformat reads a URDF through urdfdom, which writes its own lines to standard error: they
/// become faults. Restores what was there before.
class UrdfdomFaults : public console_bridge::OutputHandler {
 public:
  explicit UrdfdomFaults(const RocinanteSdfSink& sink) : sink_(sink) {
    console_bridge::useOutputHandler(this);
  }
  ~UrdfdomFaults() override { console_bridge::restorePreviousOutputHandler(); }
  UrdfdomFaults(const UrdfdomFaults&) = delete;
  UrdfdomFaults& operator=(const UrdfdomFaults&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    const bool is_error = level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR;
    if (is_error) sink_.fault(sink_.to, 1, 0, text.c_str());
  }

 private:
  const RocinanteSdfSink& sink_;
};

void read(const char* text, const RocinanteSdfSink& sink) {
  static const bool is_quiet = (keepQuiet(), true);
  static_cast<void>(is_quiet);
  sdf::ParserConfig config;
  config.SetFindCallback([](const std::string&) { return std::string(); });
  sdf::Root root;
  const UrdfdomFaults urdfdom(sink);
  tell(sink, root.LoadSdfString(text, config));
  bool is_first = true;
  const auto use = [&](const sdf::Model& model) {
    const std::string name = model.Name();
    sink.model(sink.to, name.c_str());
    if (is_first) tellModel(sink, model);
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

__attribute__((visibility("default"))) void rocinante_sdf_read(const char* text,
                                                               const RocinanteSdfSink* sink) {
  try {
    read(text, *sink);
  } catch (const std::exception& fault) {
    sink->fault(sink->to, 1, 0, fault.what());
  }
}

}  // extern "C"
