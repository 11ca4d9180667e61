#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/session/timeline.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// The cameras that every cell has: "fit", a three-quarter view, and "map", straight down. A fitted
/// view must hold what moves in the session and be the same at all its times: it is fitted to nine
/// moments, spread evenly from the first to the last. One thread; borrows cell and renderer.
class FittedCameras {
 public:
  FittedCameras(const Cell& cell, const Renderer& renderer) : cell_(cell), renderer_(renderer) {}

  static bool knows(std::string_view name) { return name == "fit" || name == "map"; }

  /// Finds the nine moments, once. Asks `session` (null: the cell at rest) for states: one that was
  /// borrowed from it before is not valid any more.
  Status prepare(Timeline* session);

  /// After prepare(). `hide` and `show` are what `choice` was made from.
  CameraView view(std::string_view name, const ViewChoice& choice,
                  const std::vector<std::string>& hide, const std::vector<std::string>& show,
                  int width, int height);

 private:
  using Asked =
      std::tuple<std::string, std::vector<std::string>, std::vector<std::string>, int, int>;

  const Cell& cell_;
  const Renderer& renderer_;
  std::vector<PosedScene> scenes_;  // without drawings: they outlive their states
  std::map<Asked, CameraView> answered_;
};

}  // namespace rocinante
