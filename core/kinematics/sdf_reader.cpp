#include "core/kinematics/sdf_reader.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/loaded_module.h"
#include "core/base/name_hint.h"
#include "core/base/plain_text.h"
#include "core/kinematics/model_draft.h"
#include "core/kinematics/sdformat_module.h"
#include "core/kinematics/urdf_reader.h"
#include "core/kinematics/visual_materials.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxSdfElements = std::size_t{1} << 20;
// SDF's own word for no limit; joints without limits carry infinity or this.
constexpr double kNoSdfLimit = 1e16;

struct SdfModule {
  RocinanteSdfRead read = nullptr;
  std::string newest;  ///< version of the format
  std::string reason;

  SdfModule() {
    const Result<void*> loaded = loadModule("librocinante_sdformat.so");
    if (!loaded.ok()) {
      reason = loaded.error().what;
      return;
    }
    const auto abi = reinterpret_cast<RocinanteSdfAbi>(functionOf(*loaded, "rocinante_sdf_abi"));
    if (abi != nullptr && abi() == ROCINANTE_SDF_ABI) {
      read = reinterpret_cast<RocinanteSdfRead>(functionOf(*loaded, "rocinante_sdf_read"));
      const auto version =
          reinterpret_cast<RocinanteSdfVersion>(functionOf(*loaded, "rocinante_sdf_version"));
      if (version != nullptr) newest = version();
    }
    if (read == nullptr || newest.empty())
      reason = "librocinante_sdformat.so has a different version";
  }
};

const SdfModule& sdfModule() {
  static const SdfModule module;
  return module;
}

/// Whether "1.10" is newer than "1.9".
bool isNewer(std::string_view version, std::string_view other) {
  const auto partsOf = [](std::string_view text) {
    std::pair<int, int> parts{};
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, parts.first);
    if (major.ptr != end) std::from_chars(major.ptr + 1, end, parts.second);
    return parts;
  };
  return partsOf(version) > partsOf(other);
}

glm::vec4 colorOf(const float (&rgba)[4]) {
  glm::vec4 color{};
  for (int i = 0; i < 4; ++i) color[i] = std::clamp(rgba[i], 0.0F, 1.0F);
  return color;
}

/// What the file gives a visual of its own; empty: nothing that is drawn.
std::optional<Material> materialOf(const RocinanteSdfMaterial& given) {
  Material material;
  bool any = true;
  if (given.has_diffuse != 0) {
    material.diffuse = colorOf(given.diffuse);
  } else if (const auto known = gazeboColor(given.script)) {
    material.name = given.script;
    material.diffuse = known->diffuse;
    material.emission = known->emission;
  } else if (given.has_ambient != 0) {
    material.diffuse = colorOf(given.ambient);
  } else {
    any = false;
  }
  if (given.has_emissive != 0) {
    if (!any) material.diffuse = {0.0F, 0.0F, 0.0F, 1.0F};  // as SDF has it: it only glows
    material.emission = glm::vec3(colorOf(given.emissive));
    any = true;
  }
  return any ? std::optional(material) : std::nullopt;
}

Mat4 matrixOfSdf(const RocinanteSdfPose& pose) {
  const double* p = pose.position;
  const double* q = pose.quaternion;
  return matrixOf({{p[0], p[1], p[2]}, {q[3], q[0], q[1], q[2]}});
}

/// The contents of the file, link by link, in SDF's own frames.
struct SdfLink {
  LinkDraft draft;
  Mat4 in_model{1.0};
};
struct SdfJoint {
  JointDraft draft;
  Mat4 in_model{1.0};
};

class SdfReader {
 public:
  SdfReader(const std::filesystem::path& path, MeshStore& meshes, FaultList& faults)
      : folder_(path.parent_path()), meshes_(meshes), faults_(faults) {
    draft_.rules = "sdf";
    draft_.several_roots = true;  // links without a joint lie where the file has them
    draft_.file = path.string();
  }

  /// `is_judged`: errors of the file are listed already, and libsdformat's say less.
  std::optional<Model> read(const std::string& text, bool is_judged) {
    is_judged_ = is_judged;
    RocinanteSdfSink sink{};
    sink.to = this;
    sink.fault = [](void* to, std::int32_t line, const char* sentence) {
      self(to).addFault(line, sentence);
    };
    sink.model = [](void* to, const char* name) { self(to).addModel(name); };
    sink.link = [](void* to, const char* name, const RocinanteSdfPose* in_model) {
      self(to).links_.push_back({});
      self(to).links_.back().draft.link.name = name;
      self(to).links_.back().in_model = matrixOfSdf(*in_model);
    };
    sink.shape = [](void* to, const RocinanteSdfShape* shape) { self(to).addShape(*shape); };
    sink.joint = [](void* to, const RocinanteSdfJoint* joint) { self(to).addJoint(*joint); };
    sdfModule().read(text.c_str(), &sink);
    if (models_ == 0) {
      if (!any_error_ && !is_judged_)
        faults_.error("sdf.no-model", {}, "the file holds no <model>");
      return std::nullopt;
    }
    toOurSpaces();
    for (SdfLink& link : links_) draft_.links.push_back(std::move(link.draft));
    for (SdfJoint& joint : joints_) draft_.joints.push_back(std::move(joint.draft));
    auto model = finishModel(std::move(draft_), faults_);
    if (model) judgeVisibility(*model, {}, faults_);
    return model;
  }

 private:
  static SdfReader& self(void* to) { return *static_cast<SdfReader*>(to); }

  void addFault(int line, const char* sentence) {
    any_error_ = true;
    if (!is_judged_) faults_.error("sdf.invalid", {line}, plainText(sentence));
  }

  // judgeSdf() has named the others.
  void addModel(const char* name) {
    if (models_++ == 0) draft_.name = name;
  }

  void addShape(const RocinanteSdfShape& given) {
    if (links_.empty()) return;
    const Place place{given.line};
    const std::string_view kind = given.kind;
    const double* size = given.size;
    const bool is_mesh = kind == "mesh";
    const bool has_length = kind == "cylinder" || kind == "capsule";
    const int sizes = is_mesh || kind == "box" ? 3 : has_length ? 2 : kind == "sphere" ? 1 : 0;
    if (sizes == 0) return;  // in the account of judgeSdf()
    for (int i = 0; i < sizes; ++i) {
      const double least = is_mesh ? -1e9 : 0.0;
      if (size[i] > least && size[i] != 0.0 && size[i] < 1e9) continue;
      faults_.error(
          "sdf.bad-size", place,
          fmt::format("the {} {} has a size of {}", kind, quotedInFault(given.name), size[i]));
      return;
    }
    Visual visual;
    visual.name = given.name;
    visual.origin = poseOf(matrixOfSdf(given.in_link));
    const auto make = [&](ShapeSize::Kind which, double x, double y, double z) {
      return meshes_.shape({which, {x, y, z}}, visual.scale, place, faults_);
    };
    if (is_mesh) {
      visual.scale = {size[0], size[1], size[2]};
      visual.mesh = meshes_.load(given.uri, folder_, 1.0, UpAxis::z, place, faults_);
      if (!takeSubmesh(given, visual)) return;
    } else if (kind == "box") {
      visual.mesh = make(ShapeSize::Kind::box, size[0], size[1], size[2]);
    } else if (kind == "sphere") {
      visual.mesh = make(ShapeSize::Kind::sphere, size[0], size[0], size[0]);
    } else {
      visual.mesh = make(kind == "cylinder" ? ShapeSize::Kind::cylinder : ShapeSize::Kind::capsule,
                         size[0], size[0], size[1]);
    }
    Link& link = links_.back().draft.link;
    if (given.is_collision != 0) {
      link.collisions.push_back(std::move(visual));
    } else {
      addVisual(given, std::move(visual), link);
    }
  }

  void addVisual(const RocinanteSdfShape& given, Visual visual, Link& link) {
    // An SDF's material is for the whole mesh, whatever the mesh has of its own.
    if (given.material != nullptr) visual.material = materialOf(*given.material);
    const auto opacity = static_cast<float>(1.0 - std::clamp(given.transparency, 0.0, 1.0));
    if (!(opacity < 1.0F)) {
      link.visuals.push_back(std::move(visual));
      return;
    }
    for (Visual& seen_through :
         withChangedMaterials(visual, [&](Material& material) { material.diffuse.a *= opacity; })) {
      link.visuals.push_back(std::move(seen_through));
    }
  }

  /// Only the parts of the mesh that the shape names. False, with a fault: there are none.
  bool takeSubmesh(const RocinanteSdfShape& given, Visual& visual) {
    const std::string_view name = given.submesh;
    if (name.empty() || !visual.mesh) return true;
    const Mesh& mesh = *visual.mesh;
    Bounds bounds;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
      const MeshPart& part = mesh.parts[i];
      if (part.group != name) continue;
      visual.mesh_parts.push_back(i);
      for (std::uint32_t index = 0; index < part.index_count; ++index) {
        bounds.add(Vec3(mesh.vertices[mesh.indices[part.first_index + index]].position));
      }
    }
    if (visual.mesh_parts.empty()) {
      std::set<std::string_view> groups;
      for (const MeshPart& part : mesh.parts) groups.insert(part.group);
      groups.erase("");
      faults_.warning(
          "sdf.unknown-submesh", {given.line},
          fmt::format("{} is not drawn: the mesh {} has no submesh {}", quotedInFault(given.name),
                      quotedPathInFault(given.uri), quotedInFault(name)),
          groups.empty()
              ? "none of its parts has a name: leave out <submesh> to draw the whole mesh"
              : whatThereIs(name, {groups.begin(), groups.end()}));
      return false;
    }
    if (given.center_submesh != 0 && !bounds.empty()) {
      const Vec3 middle = (bounds.min + bounds.max) * 0.5 * visual.scale;
      visual.origin.position = transformPoint(matrixOf(visual.origin), -middle);
    }
    return true;
  }

  void addJoint(const RocinanteSdfJoint& given) {
    SdfJoint joint;
    JointDraft& draft = joint.draft;
    draft.joint.name = given.name;
    draft.parent = given.parent;
    draft.child = given.child;
    joint.in_model = matrixOfSdf(given.in_model);
    const std::string_view type = given.type;
    const bool has_ends =
        std::fabs(given.lower) < kNoSdfLimit || std::fabs(given.upper) < kNoSdfLimit;
    if (type == "prismatic") {
      draft.joint.type = JointType::prismatic;
    } else if (type == "continuous" || type == "revolute") {
      draft.joint.type =
          type == "revolute" && has_ends ? JointType::revolute : JointType::continuous;
    } else if (type != "fixed") {
      faults_.error("sdf.unknown-joint-type", {},
                    fmt::format("joint {} is of type {}, which is not read; it is taken as fixed",
                                quotedInFault(given.name), type),
                    "types are fixed, revolute, continuous, prismatic");
    }
    if (draft.joint.type != JointType::fixed) {
      draft.joint.axis =
          normalized(Vec3{given.axis[0], given.axis[1], given.axis[2]}).value_or(Vec3{0, 0, 1});
      constexpr double kNoEnd = std::numeric_limits<double>::infinity();
      JointLimits limits;
      limits.lower = given.lower <= -kNoSdfLimit ? -kNoEnd : given.lower;
      limits.upper = given.upper >= kNoSdfLimit ? kNoEnd : given.upper;
      if (draft.joint.type == JointType::continuous) {
        limits.lower = -kNoEnd;
        limits.upper = kNoEnd;
      }
      // SDF says "none" with infinity, or below zero.
      if (std::isfinite(given.velocity) && given.velocity >= 0) limits.velocity = given.velocity;
      if (std::isfinite(given.effort) && given.effort >= 0) limits.effort = given.effort;
      if (has_ends || limits.velocity || limits.effort) draft.joint.limits = limits;
    }
    if (draft.parent == "world") needs_world_ = true;
    joints_.push_back(std::move(joint));
  }

  /// In SDF links and joints have their own spaces; here a link's space is that of its joint, and
  /// the root's that of the model.
  void toOurSpaces() {
    if (needs_world_) {
      links_.insert(links_.begin(), SdfLink{});
      links_.front().draft.link.name = "world";
    }
    std::map<std::string, Mat4> spaces;  // ours, in the model
    for (const SdfJoint& joint : joints_) spaces.emplace(joint.draft.child, joint.in_model);
    const auto spaceOf = [&](const std::string& link) {
      const auto found = spaces.find(link);
      return found == spaces.end() ? Mat4{1.0} : found->second;
    };
    for (SdfJoint& joint : joints_) {
      joint.draft.joint.origin =
          poseOf(inverseOfRigid(spaceOf(joint.draft.parent)) * joint.in_model);
    }
    for (SdfLink& link : links_) {
      const Mat4 moved = inverseOfRigid(spaceOf(link.draft.link.name)) * link.in_model;
      for (auto* shapes : {&link.draft.link.visuals, &link.draft.link.collisions}) {
        for (Visual& shape : *shapes) shape.origin = poseOf(moved * matrixOf(shape.origin));
      }
    }
  }

  std::filesystem::path folder_;
  MeshStore& meshes_;
  FaultList& faults_;
  ModelDraft draft_;
  std::vector<SdfLink> links_;
  std::vector<SdfJoint> joints_;
  std::size_t models_ = 0;
  bool any_error_ = false, is_judged_ = false;
  bool needs_world_ = false;
};

}  // namespace

std::optional<Model> readSdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                             Findings& all_faults) {
  FaultList faults(all_faults, path.string());
  if (bytes.size() > kMaxSdfBytes) {
    faults.error("sdf.invalid", {},
                 fmt::format("the file is larger than {} MiB", kMaxSdfBytes >> 20));
    return std::nullopt;
  }
  std::string problem;
  std::string decoded = xmlAsUtf8(textOf(bytes), problem);
  if (!problem.empty()) {
    faults.error("sdf.invalid", {}, std::move(problem));
    return std::nullopt;
  }
  auto text = sdfWithoutIncludes(std::move(decoded), faults);
  if (!text) return std::nullopt;
  const auto document =
      XmlDocument::parse(std::move(*text), kMaxSdfElements, {"sdf.invalid", "sdf.invalid"}, faults);
  if (!document) return std::nullopt;
  const tinyxml2::XMLElement& root = document->root();
  const std::string_view tag = root.Name();
  if (tag == "robot") {
    faults.warning("sdf.invalid", document->places().of(root), "this is URDF, and is read as that",
                   "name the file .urdf");
    return readUrdf(bytes, path, meshes, all_faults);
  }
  if (tag != "sdf") {
    faults.error("sdf.invalid", document->places().of(root),
                 fmt::format("the outermost element is <{}>, where SDF has <sdf>",
                             std::string(tag.substr(0, 60))),
                 didYouMean(tag, {"sdf"}));
    return std::nullopt;
  }
  if (sdfModule().read == nullptr) {
    faults.error("sdf.no-module", {}, "SDF is not read without its module; " + sdfModule().reason,
                 "install the package rocinante-sdf (Debian 12), build with -DROCINANTE_SDF=ON, or "
                 "convert the "
                 "file to URDF");
    return std::nullopt;
  }
  const bool sound = judgeSdf(*document, faults);
  const char* const version = root.Attribute("version");
  if (version != nullptr && isNewer(version, sdfModule().newest)) {
    faults.warning(
        "sdf.passed-over", document->places().of(root, "version"),
        fmt::format("the file is in version {} of SDF, newer than {}, the newest that is "
                    "known here: what is new in it is not read",
                    quotedInFault(version), sdfModule().newest));
  }
  std::vector<MeshWanted> wanted;
  for (std::string& name : sdfMeshes(document->text())) {
    wanted.push_back({std::move(name), path.parent_path()});
  }
  meshes.readAhead(wanted);
  return SdfReader(path, meshes, faults).read(document->text(), !sound);
}

}  // namespace rocinante
