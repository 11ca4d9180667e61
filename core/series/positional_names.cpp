#include "core/series/positional_names.h"

#include "core/kinematics/joint_values.h"

namespace rocinante {
namespace {

const Model* modelFor(const Cell& cell, std::string_view device, const DeviceState& said) {
  if (said.presence && said.presence->value.presence == Presence::added) {
    const auto added = cell.models.find(said.presence->value.model);
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
  return [&cell](std::string_view device, const DeviceState& said) {
    const Model* const model = modelFor(cell, device, said);
    return model == nullptr ? std::vector<std::string>() : positionalNames(*model);
  };
}

}  // namespace rocinante
