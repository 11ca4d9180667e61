#include "viewer/model/model_info.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/figure_text.h"
#include "core/cell/posed_scene.h"
#include "core/math/transform.h"
#include "viewer/model/model_writers.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

std::vector<InfoJoint> jointsOf(const Model& model) {
  std::vector<InfoJoint> joints;
  std::size_t next = 0;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    InfoJoint& joint = joints.emplace_back(InfoJoint{&model, i, {}});
    const std::size_t values = model.joints[i].mimic ? 0 : valueCount(model.joints[i].type);
    if (values > 0) joint.first_value = next;
    next += values;
  }
  return joints;
}

// Collects the parts of a cell's models, each once.
class Gathering {
 public:
  explicit Gathering(ModelInfo& info) : info_(info) {}

  void addModel(const Model& model) {
    if (!models_.insert(&model).second) return;
    info_.models.push_back(&model);
    for (const Link& link : model.links) {
      for (const auto* pieces : {&link.visuals, &link.collisions}) {
        for (const Visual& visual : *pieces) addVisual(visual);
      }
    }
  }

  void finish() {
    info_.meshes = meshes_.size();
    for (const auto& [path, bytes] : textures_) info_.textures.push_back({path, bytes});
    info_.textures_missing.assign(missing_.begin(), missing_.end());
  }

 private:
  void addVisual(const Visual& visual) {
    if (!visual.mesh) {
      ++info_.meshes_missing;
      return;
    }
    const Mesh& mesh = *visual.mesh;
    if (visual.material) addTexture(*visual.material);
    if (!meshes_.insert(&mesh).second) return;
    info_.geometry_bytes +=
        mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
    for (const Material& material : mesh.materials) addTexture(material);
  }

  void addTexture(const Material& material) {
    if (!material.missing_map.empty()) missing_.insert(material.missing_map);
    if (material.diffuse_map.empty()) return;
    const auto [entry, is_new] =
        textures_.try_emplace(info_.cell->shown(material.diffuse_map.string()));
    if (!is_new) return;
    std::error_code fault;
    const auto bytes = std::filesystem::file_size(material.diffuse_map, fault);
    if (!fault) entry->second = bytes;
  }

  ModelInfo& info_;
  std::set<const Model*> models_;
  std::set<const Mesh*> meshes_;
  std::map<std::string, std::optional<std::uint64_t>> textures_;
  std::set<std::string> missing_;
};

// Exact bounds of parts in world space. Bounds of an equal part with the same orientation are only
// translated, so thousands of devices of one model cost little.
class PartBounds {
 public:
  void add(const PosedPart& part, Bounds& bounds) {
    Mat4 turned = part.to_world;
    turned[3] = Vec4(0, 0, 0, 1);
    Key key{part.part, {}};
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        key.second[static_cast<std::size_t>(column * 3 + row)] = turned[column][row];
      }
    }
    const auto [known, is_new] = known_.try_emplace(key);
    if (is_new) known->second = boundsOf(part, turned);
    if (known->second.empty()) return;
    const Vec3 at = positionOf(part.to_world);
    bounds.add(known->second.min + at);
    bounds.add(known->second.max + at);
  }

 private:
  using Key = std::pair<const MeshPart*, std::array<double, 9>>;

  static Bounds boundsOf(const PosedPart& part, const Mat4& turned) {
    Bounds bounds;
    const MeshPart& run = *part.part;
    for (std::uint32_t i = 0; i < run.index_count; ++i) {
      const std::uint32_t index = part.mesh->indices[run.first_index + i];
      bounds.add(transformPoint(turned, Vec3(part.mesh->vertices[index].position)));
    }
    return bounds;
  }

  std::map<Key, Bounds> known_;
};

}  // namespace

Result<ModelInfo> modelInfo(const Cell& cell, const std::string& device) {
  PoseRequest request;
  request.device = device;
  const Result<SessionState> state = posedState(cell, request);
  if (!state) return state.error();
  const PosedScene scene = poseScene(cell, *state);

  ModelInfo info;
  info.cell = &cell;
  Gathering gathering(info);
  PartBounds bounds;
  for (const CellDevice& known : cell.devices) {
    if (!device.empty() && known.name != device) continue;
    InfoDevice& entry = info.devices.emplace_back();
    entry.device = &known;
    entry.model = cell.modelOf(known);
    if (entry.model == nullptr) continue;
    gathering.addModel(*entry.model);
    entry.joints = jointsOf(*entry.model);
    entry.movable = entry.model->movableJoints().size();
    entry.values = entry.model->positionalCount();
    info.movable += entry.movable;
    const PosedDevice* posed = scene.findDevice(known.name);
    if (posed == nullptr) continue;
    forEachPart(*posed, false, [&](const PosedPart& part) {
      entry.triangles += part.part->index_count / 3;
      bounds.add(part, entry.bounds);
    });
    info.triangles += entry.triangles;
    info.bounds.add(entry.bounds);
  }
  gathering.finish();
  if (info.devices.size() == 1 && info.devices[0].model != nullptr) {
    info.name = info.devices[0].model->name;
  }
  if (info.name.empty()) {
    const std::filesystem::path file(cell.shown(cell.file));
    info.name = file.stem().string();
    if (info.name.ends_with(".cell")) info.name.resize(info.name.size() - 5);
  }
  return info;
}

std::string limitsText(const Joint& joint) {
  const bool turns = joint.type == JointType::revolute || joint.type == JointType::continuous;
  if (joint.type == JointType::continuous) return "unlimited";
  if (!turns && joint.type != JointType::prismatic) return {};
  if (!joint.limits || !std::isfinite(joint.limits->lower)) return "unlimited";
  if (turns) return angleText(joint.limits->lower) + " to " + angleText(joint.limits->upper);
  return fmt::format("{:.6g} to {:.6g} m", joint.limits->lower, joint.limits->upper);
}

}  // namespace rocinante
