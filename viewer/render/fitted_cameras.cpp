#include "viewer/render/fitted_cameras.h"

namespace rocinante {
namespace {

constexpr int kFitMoments = 9;
/// Cached views of a suite with many sizes and choices; beyond it the cache is cleared.
constexpr std::size_t kMaxAnswers = 256;

}  // namespace

Status FittedCameras::prepare(Timeline* session, StateDamage& damage) {
  if (!scenes_.empty()) {
    damage.add(damage_);
    return {};
  }
  std::vector<PosedScene> scenes;
  StateDamage found_damage;
  const SessionState empty_state;
  const int moments = session != nullptr ? kFitMoments : 1;
  for (int i = 0; i < moments; ++i) {
    const SessionState* state = &empty_state;
    if (session != nullptr) {
      const Nanoseconds span = session->end() - session->start();
      const auto found =
          session->stateAt(session->start() + span / (moments - 1) * i, &found_damage);
      if (!found) return found.error();
      state = *found;
    }
    scenes.push_back(poseScene(cell_, *state));
    scenes.back().drawings.clear();
  }
  at_rest_ = poseScene(cell_, empty_state);
  for (const PosedScene& scene : scenes) addMovableDevices(cell_, at_rest_, scene, movable_);
  scenes_ = std::move(scenes);
  damage.add(found_damage);
  damage_ = std::move(found_damage);
  return {};
}

std::vector<Vec3> FittedCameras::pointsOf(const ViewChoice& choice,
                                          const DeviceNames* devices) const {
  std::vector<Vec3> points;
  for (const PosedScene& scene : scenes_) {
    const std::vector<Vec3> some = renderer_.visiblePoints(scene, choice, devices);
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

Result<CameraView> FittedCameras::view(std::string_view name, const ViewChoice& choice,
                                       const std::vector<std::string>& hide,
                                       const std::vector<std::string>& show, int width,
                                       int height) {
  Asked asked(std::string(name), hide, show, width, height);
  const auto known = answered_.find(asked);
  if (known != answered_.end()) return known->second;
  const std::string device(deviceOf(name));
  std::vector<Vec3> points;
  if (!device.empty()) {
    const DeviceNames one{device};
    points = pointsOf(choice, &one);
    if (points.empty()) {
      return Error{ErrorKind::not_found,
                   "camera `" + std::string(name) + "` sees nothing: no part of " + device +
                       " is visible at any of the moments that the camera is fitted to",
                   {}};
    }
  } else if (name == "fit") {
    points = pointsOf(choice, &movable_);
  }
  if (points.empty()) points = pointsOf(choice, nullptr);
  const CameraView view =
      name == "map" ? mapView(points, width, height) : fittedView(points, width, height);
  if (answered_.size() == kMaxAnswers) answered_.clear();
  answered_.emplace(std::move(asked), view);
  return view;
}

DeviceNames FittedCameras::movable(const PosedScene& scene) const {
  DeviceNames names = movable_;
  addMovableDevices(cell_, at_rest_, scene, names);
  return names;
}

}  // namespace rocinante
