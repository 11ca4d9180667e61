#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"
#include "recorder/gltf/gltf_binary.h"
#include "recorder/gltf/key_track.h"

namespace rocinante {

/// A session as a glTF scene (docs/other-formats.md, "glTF"): a node for each device and link, in
/// their spaces, with their visuals, and an animation of what moves. Give it the moments in order,
/// then write() once. Of the animation one small block for each moving value is in memory, the rest
/// in an unnamed file. Borrows the cell. One thread.
class GltfRecording {
 public:
  /// `folder` is for the unnamed file.
  static Result<GltfRecording> make(const std::string& folder);

  /// The scene at `time`; `scene` is poseScene() of `state`. The first moment is second 0.
  Status add(LogTime time, const PosedScene& scene, const SessionState& state);

  struct Facts {
    std::size_t nodes = 0, meshes = 0, cameras = 0, materials = 0;
    std::uint64_t triangles = 0;  ///< drawn when everything is shown
    std::size_t channels = 0;     ///< of the animation
    std::uint64_t keys = 0;
    double seconds = 0;              ///< of the animation
    std::vector<std::string> gaps;   ///< what is missing in the file
    std::vector<std::string> notes;  ///< what glTF has nothing for
  };
  /// unsupported beyond 2 GiB. `sink` stays open.
  Result<Facts> write(ByteSink& sink);

 private:
  explicit GltfRecording(KeySpill spill) : spill_(std::move(spill)) {}

  struct NodeTracks {
    KeyTrack translation{KeyTrack::Kind::translation};
    KeyTrack rotation{KeyTrack::Kind::rotation};
    KeyTrack shown{KeyTrack::Kind::scale};
  };
  struct DeviceTracks {
    NodeTracks base;
    std::vector<NodeTracks> links;
    std::vector<Mat4> known;  ///< links in the world; the first is the device's own
    LogTime sampled = LogTime::min();
    PosedDevice look;  ///< at the first moment that shows it, else at the first
    bool has_been_shown = false;
    bool is_here = true;  ///< at the last moment
  };
  struct CameraTracks {
    PosedCamera first;
    NodeTracks node;
    std::optional<Pose> known;
  };
  using DeviceKey = std::pair<std::string, const Model*>;

  Status addDevice(LogTime time, double seconds, const PosedDevice& device,
                   const SessionState& state);
  Status addPose(NodeTracks& node, double seconds, const Pose& pose);
  Status addShown(NodeTracks& node, double seconds, bool shown);
  Status addCameras(double seconds, const PosedScene& scene);
  Status endTracks();
  /// What floats could not hold, as gaps.
  void addLimits(Facts& facts) const;

  friend class GltfSceneWriter;
  KeySpill spill_;
  std::optional<LogTime> start_;
  double last_s_ = 0;
  std::map<DeviceKey, DeviceTracks> devices_;
  std::vector<DeviceKey> order_;  ///< of first appearance
  std::map<std::string, CameraTracks> cameras_;
  std::set<std::string> recolored_;  ///< devices whose colours change
};

}  // namespace rocinante
