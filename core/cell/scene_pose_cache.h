#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/cell/layer_index.h"
#include "core/cell/posed_scene.h"

namespace rocinante {

/// poseScene() for one state after another: recomputes only the links of devices that moved since
/// the last call. The result equals that of poseScene() bit for bit (tested). For one cell, which
/// must outlive it. One thread.
class ScenePoseCache {
 public:
  explicit ScenePoseCache(const Cell& cell) : cell_(&cell), layers_(cell) {}
  PosedScene pose(const SessionState& state);
  /// Only these devices and those that carry them, which are added to `devices` whether they are
  /// there or not, with the same bits; without looks, drawings and cameras.
  PosedScene places(const SessionState& state, std::set<std::string, std::less<>>& devices);
  /// Devices that the last pose() moved, including new ones.
  std::size_t moved() const { return moved_; }

  /// The inputs of a device's links, and the resulting transforms.
  struct Known {
    const Model* model = nullptr;
    std::vector<double> joints;
    std::vector<Mat4> links;  ///< in the device's space
    Mat4 base{1.0};
    std::vector<Mat4> link_world;
  };
  using KnownDevices = std::map<std::string, Known, std::less<>>;

 private:
  const Cell* cell_;
  LayerIndex layers_;
  KnownDevices known_;
  std::size_t moved_ = 0;
};

}  // namespace rocinante
