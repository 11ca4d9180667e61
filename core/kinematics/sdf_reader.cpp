#include "core/kinematics/sdf_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/loaded_module.h"
#include "core/base/plain_text.h"
#include "core/document/xml_tags.h"
#include "core/kinematics/model_draft.h"
#include "core/kinematics/sdformat_module.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::size_t kDeepestSdf = 100;
// libsdformat 12 is slow to make an element with all its defaults: 45 kB of small models took 7 s.
// Larger files are refused before that.
constexpr std::pair<std::string_view, int> kSdfMicroseconds[] = {
    {"world", 14'000}, {"model", 4'000}, {"population", 3'100},
    {"state", 3'100},  {"actor", 2'900}, {"link", 2'000},
    {"sensor", 1'400}, {"visual", 400},  {"collision", 400}};
constexpr std::int64_t kOtherSdfMicroseconds = 50;
constexpr std::int64_t kMaxSdfMicroseconds = 30'000'000;
// SDF's own word for no limit; joints without limits carry infinity or this.
constexpr double kNoSdfLimit = 1e16;

struct SdfModule {
  RocinanteSdfRead read = nullptr;
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
    }
    if (read == nullptr) reason = "librocinante_sdformat.so has a different version";
  }
};

const SdfModule& sdfModule() {
  static const SdfModule module;
  return module;
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
    draft_.file = path.string();
  }

  std::optional<Model> read(const std::string& text) {
    RocinanteSdfSink sink{};
    sink.to = this;
    sink.fault = [](void* to, std::int32_t is_error, std::int32_t line, const char* sentence) {
      self(to).addFault(is_error != 0, line, sentence);
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
      if (!any_error_) faults_.error("sdf.no-model", {}, "the file holds no <model>");
      return std::nullopt;
    }
    toOurSpaces();
    for (SdfLink& link : links_) draft_.links.push_back(std::move(link.draft));
    for (SdfJoint& joint : joints_) draft_.joints.push_back(std::move(joint.draft));
    return finishModel(std::move(draft_), faults_);
  }

 private:
  static SdfReader& self(void* to) { return *static_cast<SdfReader*>(to); }

  void addFault(bool is_error, int line, const char* sentence) {
    any_error_ = any_error_ || is_error;
    faults_.add(is_error ? Severity::error : Severity::warning,
                is_error ? "sdf.invalid" : "sdf.passed-over", {line}, plainText(sentence));
  }

  void addModel(const char* name) {
    if (models_++ == 0) {
      draft_.name = name;
    } else {
      faults_.warning(
          "sdf.passed-over", {},
          fmt::format("model {} is passed over; the first one is read", quotedInFault(name)));
    }
  }

  void addShape(const RocinanteSdfShape& given) {
    if (links_.empty()) return;
    Visual visual;
    visual.name = given.name;
    visual.origin = poseOf(matrixOfSdf(given.in_link));
    const std::string_view kind = given.kind;
    const double* size = given.size;
    const bool is_mesh = kind == "mesh";
    const bool has_length = kind == "cylinder" || kind == "capsule";
    const int sizes = is_mesh || kind == "box" ? 3 : has_length ? 2 : kind == "sphere" ? 1 : 0;
    if (sizes == 0) {
      faults_.note(
          "sdf.passed-over", {},
          fmt::format("{} of link {} is passed over: a {} is not drawn", quotedInFault(given.name),
                      quotedInFault(links_.back().draft.link.name), kind));
      return;
    }
    for (int i = 0; i < sizes; ++i) {
      const double least = is_mesh ? -1e9 : 0.0;
      if (size[i] > least && size[i] != 0.0 && size[i] < 1e9) continue;
      faults_.error(
          "sdf.bad-size", {},
          fmt::format("the {} {} has a size of {}", kind, quotedInFault(given.name), size[i]));
      return;
    }
    const auto make = [&](ShapeSize::Kind which, double x, double y, double z) {
      return meshes_.shape({which, {x, y, z}}, visual.scale, {}, faults_);
    };
    if (is_mesh) {
      visual.scale = {size[0], size[1], size[2]};
      visual.mesh = meshes_.load(given.uri, folder_, 1.0, UpAxis::z, {}, faults_);
    } else if (kind == "box") {
      visual.mesh = make(ShapeSize::Kind::box, size[0], size[1], size[2]);
    } else if (kind == "sphere") {
      visual.mesh = make(ShapeSize::Kind::sphere, size[0], size[0], size[0]);
    } else {
      visual.mesh = make(kind == "cylinder" ? ShapeSize::Kind::cylinder : ShapeSize::Kind::capsule,
                         size[0], size[0], size[1]);
    }
    if (given.has_color != 0 && !is_mesh) {
      Material material;
      for (int i = 0; i < 4; ++i) material.diffuse[i] = std::clamp(given.color[i], 0.0F, 1.0F);
      visual.material = material;
    }
    Link& link = links_.back().draft.link;
    (given.is_collision != 0 ? link.collisions : link.visuals).push_back(std::move(visual));
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
  bool any_error_ = false;
  bool needs_world_ = false;
};

std::int64_t sdfMicroseconds(std::string_view element) {
  const auto* const known =
      std::ranges::find(kSdfMicroseconds, element, [](const auto& one) { return one.first; });
  return known == std::end(kSdfMicroseconds) ? kOtherSdfMicroseconds : known->second;
}

/// The text with its `<include>`s blanked out, since libsdformat would open the files that they
/// name; line numbers stay. Empty with a fault when it is nested too deep, or more than libsdformat
/// makes in half a minute.
std::optional<std::string> withoutIncludes(std::string text, FaultList& faults) {
  XmlTags tags(text);
  std::vector<std::pair<const char*, const char*>> cut;
  std::size_t depth = 0, include_depth = 0;
  std::int64_t microseconds = 0;
  const char* from = nullptr;
  for (XmlTag tag; tags.next(tag);) {
    if (tag.starts && ++depth > kDeepestSdf) {
      faults.error("sdf.invalid", {},
                   fmt::format("the XML is nested deeper than {} elements", kDeepestSdf));
      return std::nullopt;
    }
    if (tag.starts && from == nullptr &&
        (microseconds += sdfMicroseconds(tag.name)) > kMaxSdfMicroseconds) {
      faults.error("sdf.invalid", {},
                   "the file is too large: libsdformat would take more than half a minute for its "
                   "elements",
                   "one file per model reads much faster");
      return std::nullopt;
    }
    if (tag.starts && from == nullptr && tag.name == "include") {
      from = tag.name.data() - 1;
      include_depth = depth;
    }
    if (!tag.ends) continue;
    if (from != nullptr && depth == include_depth) {
      const char* end = tag.inner.data() + tag.inner.size();
      while (*end != '>') ++end;
      cut.emplace_back(from, end + 1);
      from = nullptr;
    }
    if (depth > 0) --depth;
  }
  const char* counted = text.data();
  int line = 1;
  for (const auto& [begin, end] : cut) {
    line += static_cast<int>(std::count(counted, begin, '\n'));
    counted = begin;
    faults.warning("sdf.passed-over", {line}, "<include> is passed over",
                   "name the included model in a cell of its own");
  }
  for (const auto& [begin, end] : cut) {
    for (std::size_t i = static_cast<std::size_t>(begin - text.data());
         i < static_cast<std::size_t>(end - text.data()); ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
  }
  return text;
}

/// The `<uri>`s of meshes, to be read ahead.
std::vector<MeshWanted> meshesNamedIn(std::string_view text, const std::filesystem::path& folder) {
  std::vector<MeshWanted> wanted;
  XmlTags tags(text);
  bool in_mesh = false;
  for (XmlTag tag; tags.next(tag);) {
    if (tag.name == "mesh") in_mesh = tag.starts && !tag.ends;
    if (!in_mesh || tag.name != "uri" || !tag.starts || tag.ends) continue;
    const char* from = tag.inner.data() + tag.inner.size() + 1;
    const auto offset = static_cast<std::size_t>(from - text.data());
    std::string_view uri = text.substr(offset, text.find('<', offset) - offset);
    while (!uri.empty() && kXmlBlanks.find(uri.front()) != std::string_view::npos) {
      uri.remove_prefix(1);
    }
    while (!uri.empty() && kXmlBlanks.find(uri.back()) != std::string_view::npos) {
      uri.remove_suffix(1);
    }
    if (!uri.empty()) wanted.push_back({std::string(uri), folder});
  }
  return wanted;
}

}  // namespace

std::optional<Model> readSdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                             Findings& all_faults) {
  FaultList faults(all_faults, path.string());
  if (bytes.size() > kMaxSdfBytes) {
    faults.error("sdf.invalid", {},
                 fmt::format("the file is larger than {} MiB", kMaxSdfBytes >> 20));
    return std::nullopt;
  }
  if (sdfModule().read == nullptr) {
    faults.error("sdf.no-module", {}, "SDF is not read without its module; " + sdfModule().reason,
                 "install the package rocinante-sdf (Debian 12), build with -DROCINANTE_SDF=ON, or "
                 "convert the "
                 "file to URDF");
    return std::nullopt;
  }
  const auto text = withoutIncludes(std::string(textOf(bytes)), faults);
  if (!text) return std::nullopt;
  meshes.readAhead(meshesNamedIn(*text, path.parent_path()));
  return SdfReader(path, meshes, faults).read(*text);
}

}  // namespace rocinante
