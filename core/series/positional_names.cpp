#include "core/series/positional_names.h"

#include "core/kinematics/joint_values.h"

namespace rocinante {
namespace {

const Model* modelFor(const Cell& cell, std::string_view device, const DeviceState& device_state) {
  if (device_state.presence && device_state.presence->value.presence == Presence::added) {
    const auto added = cell.models.find(device_state.presence->value.model);
    if (added != cell.models.end()) return added->second.get();
  }
  if (const CellDevice* own = cell.findDevice(device)) return cell.modelOf(*own);
  for (const CellSource& source : cell.sources) {
    const auto ghost = source.ghost_of.find(std::string(device));
    if (ghost == source.ghost_of.end()) continue;
    if (const CellDevice* original = cell.findDevice(ghost->second)) {
      return cell.modelOf(*original);
    }
  }
  return nullptr;
}

}  // namespace

PositionalNames positionalNames(const Cell& cell) {
  return [&cell](std::string_view device, const DeviceState& device_state) {
    const Model* const model = modelFor(cell, device, device_state);
    return model == nullptr ? std::vector<std::string>() : positionalNames(*model);
  };
}

}  // namespace rocinante
