#include "recorder/gltf/gltf_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/figure_text.h"
#include "core/base/version.h"
#include "core/foreign/session/link_frames.h"
#include "core/math/transform.h"
#include "core/report/json_text.h"
#include "recorder/gltf/gltf_link.h"
#include "recorder/gltf/gltf_meshes.h"

namespace rocinante {
namespace {

/// Metres: a place that is off by more is missing.
constexpr double kMaxError = 5e-4;

bool sameLinks(const std::vector<Mat4>& a, const std::vector<Mat4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat4)) == 0;
}

bool isAnyShown(const PosedDevice& device) {
  return std::find(device.link_visible.begin(), device.link_visible.end(), true) !=
         device.link_visible.end();
}

std::string listOf(const std::set<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

/// The nodes and the animation of a recording that has ended.
class GltfSceneWriter {
 public:
  explicit GltfSceneWriter(const GltfRecording& recording) : recording_(recording) {}

  Result<GltfRecording::Facts> write(ByteSink& sink) {
    Json world = gltfWorld();
    addNode(std::move(world), std::nullopt);
    for (const GltfRecording::DeviceKey& key : recording_.order_) {
      addDevice(key.first, recording_.devices_.at(key));
    }
    for (const auto& [name, camera] : recording_.cameras_) {
      Json node;
      node["name"] = "camera " + name;
      node["camera"] = cameras_.size();
      cameras_.push_back(gltfCamera(camera.first));
      const std::size_t parent = nearParent("camera " + name, camera.node, 0);
      animate(addNode(std::move(node), parent), camera.node);
    }
    const Json document = describe();
    if (Status written = binary_.write(sink, document); !written) return written.error();
    facts_.nodes = nodes_.size();
    facts_.meshes = meshes_.count();
    facts_.cameras = cameras_.size();
    facts_.triangles = meshes_.triangles();
    facts_.channels = channels_.size();
    facts_.gaps = materials_.gaps();
    return facts_;
  }

 private:
  std::size_t addNode(Json node, std::optional<std::size_t> parent) {
    const std::size_t number = nodes_.size();
    nodes_.push_back(std::move(node));
    if (parent) nodes_[*parent]["children"].push_back(number);
    return number;
  }

  void addDevice(const std::string& name, const GltfRecording::DeviceTracks& tracks) {
    Json node;
    node["name"] = name;
    const std::size_t device = addNode(std::move(node), nearParent(name, tracks.base, 0));
    animate(device, tracks.base);
    const Model& model = *tracks.look.model;
    std::vector<std::size_t> numbers(model.links.size());
    addLink(tracks, model.root, device, numbers);
    for (const std::size_t joint : model.update_order) {
      const Joint& of = model.joints[joint];
      addLink(tracks, of.child, numbers[of.parent], numbers);
    }
  }

  void addLink(const GltfRecording::DeviceTracks& tracks, std::size_t link, std::size_t parent,
               std::vector<std::size_t>& numbers) {
    const PosedDevice& device = tracks.look;
    const GltfRecording::NodeTracks& moved = tracks.links[link];
    const std::string name = frameName(device.name, device.model->links[link].name);
    Json node;
    node["name"] = name;
    numbers[link] = addNode(std::move(node), nearParent(name, moved, parent));
    animateMotion(numbers[link], moved);
    std::size_t holder = numbers[link];
    const std::vector<Visual>& visuals = device.model->links[link].visuals;
    if (!visuals.empty() && !isAlwaysShown(moved.shown)) {
      // The links behind it stay: only what this one shows is scaled.
      Json shown;
      shown["name"] = name + " shown";
      holder = addNode(std::move(shown), holder);
      animateShown(holder, moved.shown);
    }
    for (Json& visual : gltfVisuals(meshes_, device, link)) addNode(std::move(visual), holder);
  }

  /// The parent of a node that is far from it: keys are floats, so a node in between has the whole
  /// kilometres of the way.
  std::size_t nearParent(const std::string& name, const GltfRecording::NodeTracks& tracks,
                         std::size_t parent) {
    const KeyTrack& translation = tracks.translation;
    if (!translation.hasOffset()) return parent;
    Json node;
    node["name"] = name + " offset";
    node["translation"] = translation.offset();
    return addNode(std::move(node), parent);
  }

  static bool isAlwaysShown(const KeyTrack& shown) {
    return shown.empty() || (!shown.animated() && shown.first().front() == 1.0F);
  }

  void animate(std::size_t node, const GltfRecording::NodeTracks& tracks) {
    animateMotion(node, tracks);
    if (!isAlwaysShown(tracks.shown)) animateShown(node, tracks.shown);
  }

  void animateMotion(std::size_t node, const GltfRecording::NodeTracks& tracks) {
    putTrack(node, tracks.translation, "translation", {0, 0, 0});
    putTrack(node, tracks.rotation, "rotation", {0, 0, 0, 1});
  }

  void animateShown(std::size_t node, const KeyTrack& shown) {
    putTrack(node, shown, "scale", {1, 1, 1});
  }

  void putTrack(std::size_t node, const KeyTrack& track, const char* path,
                const std::vector<float>& usual) {
    if (track.empty()) return;
    if (!std::equal(usual.begin(), usual.end(), track.first().begin())) {
      Json at = Json::array();
      for (const float part : track.first()) at.push_back(static_cast<double>(part));
      nodes_[node][path] = std::move(at);
    }
    if (!track.animated()) return;
    const auto view = [this](std::size_t list) {
      return binary_.addView(
          recording_.spill_.bytesOf(list), GltfBinary::Target::none, 0,
          [this, list](const UseBytes& use) { return recording_.spill_.read(list, use); });
    };
    const float first = track.firstTime(), last = track.lastTime();
    Json sampler;
    sampler["input"] = binary_.addAccessor(view(track.timeList()), 0, kGltfFloat, "SCALAR",
                                           track.keys(), accessorRange({&first, 1}, {&last, 1}));
    sampler["interpolation"] = track.kind() == KeyTrack::Kind::scale ? "STEP" : "LINEAR";
    sampler["output"] = binary_.addAccessor(view(track.valueList()), 0, kGltfFloat,
                                            track.width() == 4 ? "VEC4" : "VEC3", track.keys());
    Json channel;
    channel["sampler"] = samplers_.size();
    channel["target"]["node"] = node;
    channel["target"]["path"] = path;
    samplers_.push_back(std::move(sampler));
    channels_.push_back(std::move(channel));
    facts_.keys += track.keys();
    facts_.seconds = std::max(facts_.seconds, static_cast<double>(last));
  }

  Json describe() const {
    Json document;
    document["asset"]["version"] = "2.0";
    document["asset"]["generator"] = version();
    document["scene"] = 0;
    Json scene;
    scene["name"] = "session";
    scene["nodes"] = Json::array({0});
    // As text: the nanoseconds of a date are more than a double counts.
    scene["extras"]["rocinante_start_ns"] =
        std::to_string(nanosecondsOf(recording_.start_.value_or(LogTime{})));
    document["scenes"] = Json::array();
    document["scenes"].push_back(std::move(scene));
    document["nodes"] = nodes_;
    meshes_.describe(document);
    materials_.describe(document);
    if (!cameras_.empty()) document["cameras"] = cameras_;
    if (!channels_.empty()) {
      Json animation;
      animation["name"] = "session";
      animation["channels"] = channels_;
      animation["samplers"] = samplers_;
      document["animations"] = Json::array();
      document["animations"].push_back(std::move(animation));
    }
    binary_.describe(document);
    return document;
  }

  const GltfRecording& recording_;
  GltfBinary binary_;
  GltfMaterials materials_{binary_};
  GltfMeshes meshes_{binary_, materials_};
  Json nodes_ = Json::array();
  Json cameras_ = Json::array();
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
  GltfRecording::Facts facts_;
};

Result<GltfRecording> GltfRecording::make(const std::string& folder) {
  Result<KeySpill> spill = KeySpill::make(folder);
  if (!spill) return spill.error();
  return GltfRecording(std::move(*spill));
}

Status GltfRecording::addPose(NodeTracks& node, double seconds, const Pose& pose) {
  const std::array<double, 3> at = {pose.position.x, pose.position.y, pose.position.z};
  if (Status added = node.translation.add(spill_, seconds, at); !added) return added;
  const Quat& q = pose.orientation;
  const std::array<double, 4> turn = {q.x, q.y, q.z, q.w};
  return node.rotation.add(spill_, seconds, turn);
}

Status GltfRecording::addShown(NodeTracks& node, double seconds, bool shown) {
  const double scale = shown ? 1 : 0;
  return node.shown.add(spill_, seconds, std::array<double, 3>{scale, scale, scale});
}

Status GltfRecording::addDevice(LogTime time, double seconds, const PosedDevice& device,
                                const SessionState& state) {
  const DeviceKey key{device.name, device.model};
  const auto [place, is_new] = devices_.try_emplace(key);
  DeviceTracks& tracks = place->second;
  const bool is_shown = isAnyShown(device);
  if (is_new) {
    order_.push_back(key);
    tracks.links.resize(device.model->links.size());
    // Before it comes there is nothing of it.
    if (seconds > 0) {
      if (Status hidden = addShown(tracks.base, 0, false); !hidden) return hidden;
    }
  }
  if (is_new || (is_shown && !tracks.has_been_shown)) {
    tracks.look = device;
    tracks.has_been_shown = is_shown;
  }
  if (is_shown && device.link_color != tracks.look.link_color) recolored_.insert(device.name);
  if (Status shown = addShown(tracks.base, seconds, is_shown); !shown) return shown;
  for (std::size_t link = 0; is_shown && link < tracks.links.size(); ++link) {
    if (device.model->links[link].visuals.empty()) continue;
    Status shown = addShown(tracks.links[link], seconds, device.link_visible[link]);
    if (!shown) return shown;
  }
  std::vector<Mat4> now{device.base};
  now.insert(now.end(), device.link_world.begin(), device.link_world.end());
  // What nobody wrote since is no new value: the motion continues to the next one.
  const DeviceState* const stated = state.findDevice(device.name);
  const bool is_written = stated != nullptr && stated->last_write > tracks.sampled;
  if (!is_written && sameLinks(tracks.known, now)) return {};
  tracks.known = std::move(now);
  tracks.sampled = time;
  if (Status added = addPose(tracks.base, seconds, poseOf(device.base)); !added) return added;
  for (std::size_t link = 0; link < tracks.links.size(); ++link) {
    const auto& joint = device.model->links[link].parent_joint;
    const Mat4& parent =
        joint ? device.link_world[device.model->joints[*joint].parent] : device.base;
    Status added = addPose(tracks.links[link], seconds,
                           poseOf(inverseOfRigid(parent) * device.link_world[link]));
    if (!added) return added;
  }
  return {};
}

Status GltfRecording::addCameras(double seconds, const PosedScene& scene) {
  for (const PosedCamera& camera : scene.cameras) {
    const std::optional<Pose> pose = gltfCameraPose(camera);
    if (!pose) continue;
    CameraTracks& tracks = cameras_[camera.name];
    if (!tracks.known) tracks.first = camera;
    if (tracks.known == pose) continue;
    tracks.known = pose;
    if (Status added = addPose(tracks.node, seconds, *pose); !added) return added;
  }
  return {};
}

Status GltfRecording::add(LogTime time, const PosedScene& scene, const SessionState& state) {
  if (!start_) start_ = time;
  const double seconds = secondsOf(time - *start_);
  last_s_ = seconds;
  for (auto& [key, tracks] : devices_) tracks.is_here = false;
  for (const PosedDevice& device : scene.devices) {
    if (device.ghost) continue;
    if (Status added = addDevice(time, seconds, device, state); !added) return added;
    devices_.at({device.name, device.model}).is_here = true;
  }
  for (auto& [key, tracks] : devices_) {
    if (tracks.is_here) continue;
    if (Status gone = addShown(tracks.base, seconds, false); !gone) return gone;
  }
  return addCameras(seconds, scene);
}

Status GltfRecording::endTracks() {
  const auto end = [this](NodeTracks& node) -> Status {
    for (KeyTrack* track : {&node.translation, &node.rotation, &node.shown}) {
      if (Status ended = track->end(spill_); !ended) return ended;
    }
    return {};
  };
  for (auto& [key, tracks] : devices_) {
    if (Status ended = end(tracks.base); !ended) return ended;
    for (NodeTracks& link : tracks.links) {
      if (Status ended = end(link); !ended) return ended;
    }
  }
  for (auto& [name, camera] : cameras_) {
    if (Status ended = end(camera.node); !ended) return ended;
  }
  return {};
}

void GltfRecording::addLimits(Facts& facts) const {
  std::uint64_t merged = 0;
  double worst = 0;
  std::string worst_node;
  const auto look = [&](const std::string& name, const NodeTracks& node) {
    for (const KeyTrack* track : {&node.translation, &node.rotation, &node.shown}) {
      merged = std::max(merged, track->merged());
    }
    if (node.translation.worstError() <= std::max(worst, kMaxError)) return;
    worst = node.translation.worstError();
    worst_node = name;
  };
  for (const auto& [key, tracks] : devices_) {
    look(key.first, tracks.base);
    for (std::size_t i = 0; i < tracks.links.size(); ++i) {
      look(frameName(key.first, key.second->links[i].name), tracks.links[i]);
    }
  }
  for (const auto& [name, camera] : cameras_) look("camera " + name, camera.node);
  if (merged > 0) {
    const auto end = static_cast<float>(last_s_);
    facts.gaps.push_back(fmt::format(
        "{} of one value fall on the time of the next and are left out: glTF counts seconds in "
        "floats, {:.2g} s apart at {:.0f} s; begin later with --from, or give --every",
        countText(merged, "key"), std::nextafter(end, 2 * end + 1) - end, last_s_));
  }
  if (worst > 0) {
    facts.gaps.push_back(fmt::format(
        "{} is off by up to {:.2g} m: glTF has floats, and it goes far from where it begins; "
        "choose a part with --from and --until",
        worst_node, worst));
  }
}

Result<GltfRecording::Facts> GltfRecording::write(ByteSink& sink) {
  if (Status ended = endTracks(); !ended) return ended.error();
  Result<Facts> facts = GltfSceneWriter(*this).write(sink);
  if (!facts) return facts;
  addLimits(*facts);
  if (!recolored_.empty()) {
    facts->notes.push_back(
        fmt::format("colours change, and are those of the first moment: {}", listOf(recolored_)));
  }
  return facts;
}

}  // namespace rocinante
