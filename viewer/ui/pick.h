#pragma once

#include <optional>

#include "core/model/posed_scene.h"
#include "viewer/render/camera.h"
#include "viewer/render/view_choice.h"

namespace rocinante {

/// A line of sight into the scene.
struct SightLine {
  Vec3 from{};
  Vec3 direction{};  ///< unit length
};

/// What a click met first.
struct Picked {
  std::size_t device = 0;  ///< into PosedScene::devices
  std::size_t link = 0;    ///< of its model
  double distance_m = 0;   ///< along the line
  Vec3 point{};            ///< in the world
};

/// The line through the middle of pixel (x, y), from the top left.
SightLine sightLine(const Camera& camera, double x_px, double y_px);

/// The nearest visible triangle of the scene on the line, from either side; empty when there is
/// none. Behind the start nothing is met. Pure: asks the meshes as their files have them, whatever
/// detail is drawn.
std::optional<Picked> pick(const PosedScene& scene, const ViewChoice& choice,
                           const SightLine& line);

}  // namespace rocinante
