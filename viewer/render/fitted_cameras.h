#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/session/timeline.h"
#include "viewer/render/renderer.h"
#include "viewer/view/movable_devices.h"

namespace rocinante {

/// The built-in cameras: "fit", a three-quarter view of the devices that can move (of everything
/// when none is visible), "fit:DEVICE", the same for one device, and "map", everything from
/// straight above. A fitted view must contain all movement of the session and be constant: it is
/// fitted to nine evenly spaced moments from the first to the last. Not thread-safe; borrows cell
/// and renderer.
class FittedCameras {
 public:
  FittedCameras(const Cell& cell, const Renderer& renderer) : cell_(cell), renderer_(renderer) {}

  static bool knows(std::string_view name) {
    return name == "fit" || name == "map" || name.starts_with(kOfDevice);
  }
  /// DEVICE of "fit:DEVICE"; empty for other names.
  static std::string_view deviceOf(std::string_view name) {
    return name.starts_with(kOfDevice) ? name.substr(kOfDevice.size()) : std::string_view();
  }

  /// Computes the states of the nine moments, once. Queries `session` (null: the cell at rest),
  /// which invalidates a state borrowed from it before. Damage of the log that affects these states
  /// is added to `damage` each time.
  Status prepare(Timeline* session, StateDamage& damage);

  /// Requires prepare(). `hide` and `show` must be those of `choice`. not_found when nothing of the
  /// device is visible at any of the moments.
  Result<CameraView> view(std::string_view name, const ViewChoice& choice,
                          const std::vector<std::string>& hide,
                          const std::vector<std::string>& show, int width, int height);

  /// Requires prepare(). The devices that can move at one of the moments or in `scene`.
  DeviceNames movable(const PosedScene& scene) const;

 private:
  static constexpr std::string_view kOfDevice = "fit:";
  using Asked =
      std::tuple<std::string, std::vector<std::string>, std::vector<std::string>, int, int>;

  std::vector<Vec3> pointsOf(const ViewChoice& choice, const DeviceNames* devices) const;

  const Cell& cell_;
  const Renderer& renderer_;
  PosedScene at_rest_;
  std::vector<PosedScene> scenes_;  // without drawings: they outlive their states
  DeviceNames movable_;
  StateDamage damage_;  // of those moments
  std::map<Asked, CameraView> answered_;
};

}  // namespace rocinante
