#include "core/cell/posed_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/cell/device_appearance.h"
#include "core/cell/layer_index.h"
#include "core/cell/scene_pose_cache.h"
#include "core/math/transform.h"
#include "core/mesh/mesh_builder.h"

namespace rocinante {
namespace {

// A present device, before its place in the world is known.
struct Standing {
  PosedDevice device;
  Pose pose;
  std::string carrier, carrier_link;    // empty carrier: the world
  std::optional<std::uint32_t> color;   // the cell's own
  const CellDevice* of_cell = nullptr;  // itself, or the device it is a ghost of; null: neither
  std::vector<Mat4> links;              // in the device's space; those of `known` where it has some
  ScenePoseCache::Known* known = nullptr;  // null: nothing is kept
  bool links_moved = true;

  const std::vector<Mat4>& linksInDevice() const { return known != nullptr ? known->links : links; }
};

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

class ScenePoser {
 public:
  ScenePoser(const Cell& cell, const LayerIndex& layers, const SessionState& state,
             ScenePoseCache::KnownDevices* known)
      : cell_(cell), layers_(layers), state_(state), known_(known) {}

  std::size_t moved() const { return moved_; }

  /// The chosen devices and their carriers, which are added to `devices`.
  PosedScene places(std::set<std::string, std::less<>>& devices) {
    only_ = &devices;
    // Until nothing is carried by a device that is left out: no more often than there are carriers.
    for (std::size_t count = 0; count != devices.size();) {
      count = devices.size();
      if (!standing_.empty() && known_ != nullptr) known_->clear();
      standing_.clear();
      scene_.device_by_name.clear();
      standAll();
      for (const Standing& standing : standing_) {
        // Also one that is not there yet: it moves what it carries as it comes.
        if (!standing.carrier.empty()) devices.insert(standing.carrier);
      }
    }
    placeAll();
    for (Standing& standing : standing_) scene_.devices.push_back(std::move(standing.device));
    return std::move(scene_);
  }

  PosedScene pose() {
    standAll();
    placeAll();
    const DeviceAppearance dress(layers_, state_);
    for (Standing& standing : standing_) {
      dress.dress(standing.device, standing.color, standing.of_cell);
      if (!standing.device.placed) standing.device.link_visible.assign(1, false);
      noteLooks(standing.device);
      scene_.devices.push_back(std::move(standing.device));
    }
    addDrawings();
    addCameras();
    return std::move(scene_);
  }

 private:
  void standAll() {
    addCellDevices();
    addSessionDevices();
    addGhosts();
  }

  bool isChosen(const std::string& name) const { return only_ == nullptr || only_->contains(name); }

  const DeviceState* stateOf(const std::string& name) const {
    const auto found = state_.devices().find(name);
    return found == state_.devices().end() ? nullptr : &found->second;
  }

  const Model* modelNamed(const std::string& name) const {
    const auto found = cell_.models.find(name);
    return found == cell_.models.end() ? nullptr : found->second.get();
  }

  static bool isRemoved(const DeviceState* state) {
    return state && state->presence && state->presence->value.presence == Presence::removed;
  }

  static bool isAdded(const DeviceState* state) {
    return state && state->presence && state->presence->value.presence == Presence::added;
  }

  Standing& addStanding(const std::string& name, const Model& model, const DeviceState* state) {
    Standing& standing = standing_.emplace_back();
    const bool first = scene_.device_by_name.emplace(name, standing_.size() - 1).second;
    standing.device.name = name;
    standing.device.model = &model;
    const JointVector joints = jointsOf(model, state);
    if (known_ == nullptr || !first) {
      standing.links = linkPoses(model, joints);
    } else {
      computeLinks(standing, (*known_)[name], joints);
    }
    if (state && state->pose) {
      standing.pose = state->pose->value.pose;
      const Path& carrier = state->pose->value.carrier;
      if (!carrier.is_layer) {
        standing.carrier = carrier.first;
        standing.carrier_link = carrier.second;
      }
    }
    return standing;
  }

  /// The links of a device, from the cache or computed.
  static void computeLinks(Standing& standing, ScenePoseCache::Known& known,
                           const JointVector& joints) {
    const Model* model = standing.device.model;
    standing.known = &known;
    standing.links_moved = known.model != model || !sameBits(known.joints, joints.values);
    if (!standing.links_moved) return;
    known.model = model;
    known.joints = joints.values;
    known.links = linkPoses(*model, joints);
  }

  void addCellDevices() {
    for (const CellDevice& device : cell_.devices) {
      if (!isChosen(device.name)) continue;
      const DeviceState* state = stateOf(device.name);
      if (isRemoved(state) || (device.optional && !isAdded(state))) continue;
      const Model* model = cell_.modelOf(device);
      if (isAdded(state)) {
        // The cell's own model, by any of its names, keeps the cell's changes of its looks.
        const Model* added = modelNamed(state->presence->value.model);
        if (added != nullptr && added != modelNamed(device.model)) model = added;
      }
      if (model == nullptr) continue;
      Standing& standing = addStanding(device.name, *model, state);
      standing.device.layer = device.layer;
      standing.of_cell = &device;
      if (device.color) standing.color = packedColor(*device.color);
      if (!state || !state->pose) {
        standing.pose = device.pose;
        standing.carrier = device.on_device;
        standing.carrier_link = device.on_link;
      }
    }
  }

  void addSessionDevices() {
    for (const auto& [name, state] : state_.devices()) {
      if (!isAdded(&state) || !isChosen(name) || cell_.findDevice(name) != nullptr) continue;
      if (const Model* model = modelNamed(state.presence->value.model))
        addStanding(name, *model, &state);
    }
    if (const Model* bare = modelNamed(cell_.bare_model)) addBareDevices(*bare);
  }

  /// What no cell describes. Where a link is that carries one, nobody knows.
  void addBareDevices(const Model& bare) {
    for (const auto& [name, state] : state_.devices()) {
      if (isRemoved(&state) || scene_.device_by_name.contains(name)) continue;
      if (cell_.findDevice(name) != nullptr) continue;
      PosedDevice& device = addStanding(name, bare, &state).device;
      device.bare = true;
      device.placed = state.pose && state.pose->value.carrier.first.empty();
    }
  }

  // A ghost is placed like its original until a packet moves it.
  void addGhosts() {
    for (const CellSource& source : cell_.sources) {
      for (const auto& [ghost, original] : source.ghost_of) {
        if (!isChosen(ghost)) continue;
        const DeviceState* state = stateOf(ghost);
        const CellDevice* device = cell_.findDevice(original);
        if (!state || isRemoved(state) || !device || scene_.device_by_name.contains(ghost))
          continue;
        const Model* model = cell_.modelOf(*device);
        if (model == nullptr || !(state->pose || state->joints || !state->named_joints.empty())) {
          continue;
        }
        Standing& standing = addStanding(ghost, *model, state);
        standing.device.ghost = true;
        standing.device.layer = device->layer;
        standing.of_cell = device;
        standing.color = kGhostColor;
        if (state->pose) continue;
        const DeviceState* real = stateOf(original);
        if (real && real->pose) {
          standing.pose = real->pose->value.pose;
          standing.carrier = real->pose->value.carrier.first;
          standing.carrier_link = real->pose->value.carrier.second;
        } else {
          standing.pose = device->pose;
          standing.carrier = device->on_device;
          standing.carrier_link = device->on_link;
        }
      }
    }
  }

  // The carrier of a device; empty when it is placed in the world.
  std::optional<std::size_t> carrierOf(const Standing& standing) const {
    if (standing.carrier.empty()) return std::nullopt;
    const auto found = scene_.device_by_name.find(standing.carrier);
    if (found == scene_.device_by_name.end()) return std::nullopt;
    if (!standing.carrier_link.empty() &&
        !standing_[found->second].device.model->findLink(standing.carrier_link)) {
      return std::nullopt;
    }
    return found->second;
  }

  // Walks up each chain of carriers once, then places downwards. All devices of a loop are placed
  // in the world.
  void placeAll() {
    enum class Mark : std::uint8_t { fresh, on_chain, placed };
    std::vector<Mark> marks(standing_.size(), Mark::fresh);
    std::vector<std::size_t> chain;
    for (std::size_t first = 0; first < standing_.size(); ++first) {
      std::optional<std::size_t> at = first;
      while (at && marks[*at] == Mark::fresh) {
        marks[*at] = Mark::on_chain;
        chain.push_back(*at);
        at = carrierOf(standing_[*at]);
      }
      if (at && marks[*at] == Mark::on_chain) {
        for (std::size_t i = chain.size(); i-- > 0;) {
          standing_[chain[i]].carrier.clear();
          if (chain[i] == *at) break;
        }
      }
      for (; !chain.empty(); chain.pop_back()) {
        place(standing_[chain.back()]);
        marks[chain.back()] = Mark::placed;
      }
    }
  }

  void place(Standing& standing) {
    Mat4 carrier{1.0};
    standing.device.pose = standing.pose;
    if (const auto found = carrierOf(standing)) {
      standing.device.carrier = standing.carrier;
      standing.device.carrier_link = standing.carrier_link;
      const Standing& below = standing_[*found];
      carrier = standing.carrier_link.empty()
                    ? below.device.base
                    : below.device.link_world[*below.device.model->findLink(standing.carrier_link)];
    }
    PosedDevice& device = standing.device;
    device.base = carrier * matrixOf(standing.pose);
    ScenePoseCache::Known* const known = standing.known;
    if (known != nullptr && !standing.links_moved &&
        std::memcmp(&known->base, &device.base, sizeof(Mat4)) == 0) {
      device.link_world = known->link_world;
      return;
    }
    const std::vector<Mat4>& links = standing.linksInDevice();
    device.link_world.reserve(links.size());
    for (const Mat4& link : links) device.link_world.push_back(device.base * link);
    if (known == nullptr) return;
    known->base = device.base;
    known->link_world = device.link_world;
    ++moved_;
  }

  void noteLooks(const PosedDevice& device) {
    if (device.link_look.empty()) return;
    scene_.has_looks = true;
    scene_.has_collision =
        scene_.has_collision || std::ranges::any_of(device.link_look, [](const LayerLook& look) {
          return look.collision.value_or(CollisionLook::off) != CollisionLook::off;
        });
  }

  Mat4 spaceOf(const Path& carrier) const {
    if (carrier.first.empty() || carrier.is_layer) return Mat4{1.0};
    return scene_.find(carrier.first, carrier.second).value_or(Mat4{1.0});
  }

  void addDrawings() {
    for (const auto& [key, drawing] : state_.drawings()) {
      scene_.drawings.push_back({key.first, key.second, &drawing, spaceOf(drawing.carrier)});
    }
  }

  void addCameras() {
    for (const CellCamera& camera : cell_.cameras) {
      PosedCamera posed{camera.name, camera.eye,       camera.target,
                        camera.up,   camera.fov_deg,   camera.ortho_height_m,
                        false,       camera.intrinsics};
      Mat4 space{1.0};
      if (!camera.on_device.empty()) {
        space = scene_.find(camera.on_device, camera.on_link).value_or(space);
      } else if (!camera.follow_device.empty()) {
        const auto followed = scene_.find(camera.follow_device, camera.follow_link);
        if (followed) space = translationMatrix(positionOf(*followed));
      }
      PosedCamera& placed = scene_.cameras.emplace_back(moved(std::move(posed), space));
      if (camera.look_device.empty()) continue;
      const auto seen = scene_.find(camera.look_device, camera.look_link);
      placed.target = camera.target + (seen ? positionOf(*seen) : Vec3(0, 0, 0));
    }
    for (const auto& [name, item] : state_.views()) {
      const ViewValue& view = item.value;
      PosedCamera posed{name, view.eye, view.target, view.up, view.fov_deg, view.ortho_height_m,
                        true};
      scene_.cameras.push_back(moved(std::move(posed), spaceOf(view.carrier)));
    }
  }

  static PosedCamera moved(PosedCamera camera, const Mat4& space) {
    camera.eye = transformPoint(space, camera.eye);
    camera.target = transformPoint(space, camera.target);
    camera.up = transformDirection(space, camera.up);
    return camera;
  }

  const Cell& cell_;
  const LayerIndex& layers_;
  const SessionState& state_;
  ScenePoseCache::KnownDevices* known_;
  const std::set<std::string, std::less<>>* only_ = nullptr;  // null: every device
  std::size_t moved_ = 0;
  std::vector<Standing> standing_;
  PosedScene scene_;
};

}  // namespace

JointVector jointsOf(const Model& model, const DeviceState* state) {
  JointVector joints = zeroJoints(model);
  if (state == nullptr) return joints;
  if (state->joints && state->joints->value.size() == model.positionalCount()) {
    std::size_t next = 0;
    for (const std::size_t joint : model.movableJoints()) {
      for (std::size_t i = 0; i < valueCount(model.joints[joint].type); ++i) {
        joints.values[joints.first_value[joint] + i] = state->joints->value[next++];
      }
    }
  }
  for (const auto& [name, item] : state->named_joints) {
    if (const auto value = model.findJointValue(name)) {
      joints.values[joints.first_value[value->joint] + value->component] = item.value;
    }
  }
  applyMimics(model, joints);
  return joints;
}

PosedScene poseScene(const Cell& cell, const SessionState& state) {
  return ScenePoser(cell, LayerIndex(cell), state, nullptr).pose();
}

PosedScene ScenePoseCache::pose(const SessionState& state) {
  ScenePoser poser(*cell_, layers_, state, &known_);
  PosedScene scene = poser.pose();
  moved_ = poser.moved();
  // A session may name new devices without end: absent ones are dropped from the cache.
  if (known_.size() > scene.devices.size()) {
    std::erase_if(known_,
                  [&](const auto& known) { return scene.findDevice(known.first) == nullptr; });
  }
  return scene;
}

PosedScene ScenePoseCache::places(const SessionState& state,
                                  std::set<std::string, std::less<>>& devices) {
  return ScenePoser(*cell_, layers_, state, &known_).places(devices);
}

}  // namespace rocinante
