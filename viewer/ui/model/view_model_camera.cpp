// The part of ViewModel for the camera of its picture.
#include <algorithm>
#include <utility>

#include "core/math/transform.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/view/camera_choice.h"

namespace rocinante {

void ViewModel::toggleFollowing() {
  followed_ = followed_.device.empty() ? selected : Selection();
  followed_at_.reset();
  follow();
}

void ViewModel::follow() {
  if (followed_.device.empty()) return;
  const auto space = scene_.find(followed_.device, followed_.link);
  if (!space) return followed_at_.reset();
  const Vec3 at = positionOf(*space);
  if (followed_at_ && at != *followed_at_) holdCamera().shift(at - *followed_at_);
  followed_at_ = at;
}

CameraView ViewModel::cameraView() {
  if (hasBuiltInCamera()) return *named_view_;
  if (!camera_name_.empty()) {
    auto view = chooseCamera(camera_name_, scene_);
    if (view.ok()) {
      viewer.panels.complaint.clear();
      named_view_ = *view;
      return *view;
    }
    // A removed view or carrier, as of a window that closed: keep the present camera.
    viewer.panels.complaint = view.error().text();
    camera_name_.clear();
    if (named_view_) turntable_ = Turntable(*named_view_);
  }
  return turntable_.view();
}

void ViewModel::useCamera(const std::string& name) {
  camera_name_ = name;
  viewer.built_in_wanted.clear();
  named_view_.reset();
  has_built_in_ = false;
  followed_ = {};
}

void ViewModel::useBuiltInCamera(const std::string& name, const CameraView& view) {
  useCamera(name);
  named_view_ = view;
  has_built_in_ = true;
}

void ViewModel::addCamera(CellCamera camera) {
  camera_name_ = camera.name;
  viewer.built_in_wanted.clear();
  has_built_in_ = false;
  cell_->cameras.push_back(std::move(camera));
  // Cameras are posed with the scene. What cannot be read was said when it was shown.
  static_cast<void>(pose(shownTime()));
}

void ViewModel::resetCamera() {
  turntable_ = Turntable();
  viewer.built_in_wanted.clear();
  followed_ = {};
  has_built_in_ = false;
  camera_name_ = cell_->cameras.empty() ? std::string() : cell_->cameras.front().name;
}

Turntable& ViewModel::holdCamera() {
  viewer.built_in_wanted.clear();
  if (!camera_name_.empty()) {
    turntable_ = Turntable(cameraView());
    camera_name_.clear();
  }
  return turntable_;
}

void ViewModel::fit(const std::vector<Vec3>& points, int width, int height) {
  holdCamera().fit(points, width, height);
}

std::vector<std::string> ViewModel::viewsOfOthers() const {
  std::vector<std::string> names;
  for (const PosedCamera& camera : scene_.cameras) {
    if (camera.of_session) names.push_back(camera.name);
  }
  return names;
}

std::string ViewModel::watched() const {
  const PosedCamera* const camera = scene_.findCamera(camera_name_);
  return camera != nullptr && camera->of_session ? camera_name_ : std::string();
}

void ViewModel::stopWatching() {
  if (!watched().empty()) holdCamera();
}

std::vector<std::string> ViewModel::cameraNames() const {
  std::vector<std::string> names;
  for (const PosedCamera& camera : scene_.cameras) {
    if (std::ranges::find(names, camera.name) == names.end()) names.push_back(camera.name);
  }
  return names;
}

}  // namespace rocinante
