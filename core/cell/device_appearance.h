#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/cell/layer_index.h"
#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// What of a device is seen, and how: docs/cell-format.md, section "What is drawn". Packets outrank
/// the cell; what is said of a link outranks what is said of its device. A layer stands directly
/// below what it holds, and of several the last one counts; but for a link to be seen, all must be
/// shown: it, its device and their layers. Borrows both for its life.
class DeviceAppearance {
 public:
  DeviceAppearance(const LayerIndex& layers, const SessionState& state)
      : layers_(layers), state_(state) {}

  /// Fills all of `device` that is not about where it is. `own`: the cell's colour; `of_cell`: the
  /// cell's device that it is, or is a ghost of; null when it is neither.
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
