// Any bytes as a cell. What comes back must be drawable in the empty state.

#include <cstdlib>

#include "core/cell/posed_scene.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  CellOptions options;
  options.geometry = false;
  const auto cell = readCell(std::as_bytes(std::span(data, size)), "fuzz.cell.toml", options);
  if (!cell.ok()) {
    require(!cell.error().what.empty());
    return 0;
  }
  const PosedScene scene = poseScene(*cell, SessionState{});
  for (const PosedDevice& device : scene.devices) {
    require(device.link_world.size() == device.model->links.size());
    require(device.link_visible.size() == device.link_world.size());
    require(device.link_color.size() == device.link_world.size());
  }
  for (const Finding& fault : cell->faults) require(!fault.print().empty());
  return 0;
}
