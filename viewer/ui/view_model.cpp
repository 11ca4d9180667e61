#include "viewer/ui/view_model.h"

#include <algorithm>
#include <utility>

#include "viewer/render/camera_choice.h"

namespace rocinante {

Result<ViewModel> ViewModel::make(Cell cell, std::optional<Timeline> session,
                                  std::optional<LiveFeed> feed, std::vector<std::string> hide,
                                  std::vector<std::string> show) {
  ViewModel model;
  model.cell_ = std::make_unique<Cell>(std::move(cell));
  model.hidden_.insert(hide.begin(), hide.end());
  model.shown_paths_.insert(show.begin(), show.end());
  if (auto chosen = model.updateChoice(); !chosen) return chosen.error();
  model.feed_ = std::move(feed);
  if (session) {
    auto events = session->events();
    if (!events.ok()) return events.error();
    model.events_ = **events;
    model.transport_.emplace(session->start(), session->end());
    model.session_ = std::move(session);
  }
  if (!model.cell_->cameras.empty()) model.useCamera(model.cell_->cameras.front().name);
  return model;
}

Status ViewModel::updateChoice() {
  auto choice = ViewChoice::make({hidden_.begin(), hidden_.end()},
                                 {shown_paths_.begin(), shown_paths_.end()});
  if (!choice.ok()) return choice.error();
  choice_ = std::move(*choice);
  return {};
}

Result<bool> ViewModel::update(SteadyTime now) {
  bool changed = !shown_.has_value();
  LogTime moment{};
  if (transport_) {
    moment = transport_->position(now);
    if (shown_ != moment) {
      const auto state = session_->stateAt(moment);
      if (!state.ok()) return state.error();
      state_ = *state;
      changed = true;
    }
  } else if (feed_) {
    if (auto snapshot = feed_->take()) {
      live_ = std::move(snapshot);
      state_ = &live_->state;
      moment = live_->time;
      changed = true;
    }
  } else {
    state_ = &nothing_said_;
  }
  shown_ = moment;
  if (changed) scene_ = poseScene(*cell_, *state_);
  return changed;
}

CameraView ViewModel::cameraView() {
  if (!camera_name_.empty()) {
    auto view = chooseCamera(camera_name_, scene_);
    if (view.ok()) {
      complaint.clear();
      return *view;
    }
    // A view that a source took back, or a carrier that is gone: stay where we were.
    complaint = view.error().text();
    camera_name_.clear();
  }
  return turntable_.view();
}

void ViewModel::useCamera(const std::string& name) { camera_name_ = name; }

Turntable& ViewModel::holdCamera() {
  if (!camera_name_.empty()) {
    turntable_ = Turntable(cameraView());
    camera_name_.clear();
  }
  return turntable_;
}

void ViewModel::fit(const std::vector<Vec3>& points, int width, int height) {
  holdCamera().fit(points, width, height);
}

std::vector<std::string> ViewModel::cameraNames() const {
  std::vector<std::string> names;
  for (const PosedCamera& camera : scene_.cameras) {
    if (std::ranges::find(names, camera.name) == names.end()) names.push_back(camera.name);
  }
  return names;
}

bool ViewModel::setVisible(const std::string& path, bool visible) {
  const auto hidden_before = hidden_;
  const auto shown_before = shown_paths_;
  (visible ? shown_paths_ : hidden_).insert(path);
  (visible ? hidden_ : shown_paths_).erase(path);
  if (updateChoice()) return true;
  hidden_ = hidden_before;
  shown_paths_ = shown_before;
  return false;
}

std::optional<bool> ViewModel::chosenVisibility(const std::string& path) const {
  if (hidden_.contains(path)) return false;
  if (shown_paths_.contains(path)) return true;
  return std::nullopt;
}

}  // namespace rocinante
