#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/cell/layer_index.h"
#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Of ghosts: 0xRRGGBBAA.
inline constexpr std::uint32_t kGhostColor = 0x66A3FF59;

/// Which parts of a device are visible, and how: docs/cell-format.md, section "What is drawn".
/// Packets override the cell, and settings of a link override those of its device. A layer's
/// settings rank directly below those of the things that it holds, and the last of several layers
/// wins. A link is visible only if it, its device and all their layers are shown. Borrows both for
/// its life.
class DeviceAppearance {
 public:
  DeviceAppearance(const LayerIndex& layers, const SessionState& state)
      : layers_(layers), state_(state) {}

  /// Fills all of `device` except its place. `own`: the cell's colour; `of_cell`: the cell's device
  /// that it is, or is a ghost of; null when it is neither.
  void dress(PosedDevice& device, std::optional<std::uint32_t> own,
             const CellDevice* of_cell) const;

 private:
  struct Whole;
  using Own = std::optional<std::uint32_t>;

  PosedShare shareOf(std::string_view name, const CellLayer* listed, const Own& own) const;
  void addMembers(PosedDevice& device, std::string_view name, const Own& own) const;
  void addShares(PosedDevice& device, const Own& own, const CellDevice* of_cell) const;
  void dressByLayers(PosedDevice& device) const;
  void dressBySession(PosedDevice& device, const Own& own) const;

  const LayerIndex& layers_;
  const SessionState& state_;
};

}  // namespace rocinante
