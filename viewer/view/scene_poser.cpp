#include "viewer/view/scene_poser.h"

#include <utility>

namespace rocinante {

Status ScenePoser::findTrails(const RenderStyle& style, Timeline* session, LogTime time,
                              StateDamage& damage, FrameExtras& extras) {
  extras.trails.clear();
  if (style.trails.empty() || session == nullptr) return {};
  if (!trails_) trails_.emplace(*cell_);
  auto found = trails_->find(style.trails, *session, time, damage);
  if (!found) return found.error();
  extras.trails = std::move(*found);
  return {};
}

PosedScene ScenePoser::pose(const RenderStyle& style, const SessionState& state,
                            FrameExtras& extras) {
  PosedScene scene = poses_.pose(state);
  extras.limits.clear();
  extras.clearances.clear();
  if (style.limits) extras.limits = limitLevels(scene, state);
  if (style.clearance) {
    if (!gauge_) gauge_.emplace(*cell_);
    extras.clearances = clearanceLines(*cell_, *gauge_, state);
  }
  return scene;
}

}  // namespace rocinante
