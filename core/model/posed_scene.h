#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A device of the cell, or one that `add` brought, with every link where the state puts it.
struct PosedDevice {
  std::string name;
  const Model* model = nullptr;
  std::vector<Mat4> link_world;           ///< by link of the model
  std::vector<bool> link_visible;
  std::vector<std::optional<std::uint32_t>> link_color;  ///< 0xRRGGBBAA; empty: materials' own
  std::string layer;
  bool visible = true;
};

/// A drawing with its carrier resolved.
struct PosedDrawing {
  std::string source, id;
  const Drawing* drawing = nullptr;  ///< of the state; valid while the state is unchanged
  Mat4 to_world{1.0};
};

/// The cell in one state: what the app stage hands to cull and draw. A plain value (but for the
/// borrowed model and drawing pointers).
struct PosedScene {
  std::vector<PosedDevice> devices;  ///< the cell's order, then added ones by name
  std::vector<PosedDrawing> drawings;
  const PosedDevice* findDevice(std::string_view name) const;
  /// World transform of DEVICE or DEVICE/LINK; empty when there is none.
  std::optional<Mat4> find(std::string_view device, std::string_view link) const;
};

/// Puts the cell into the state. Unknown devices and joints are left out (check tells of them);
/// a carried device whose carrier is missing or carries it in turn stands in the world.
PosedScene poseScene(const Cell& cell, const SessionState& state);

}  // namespace rocinante
