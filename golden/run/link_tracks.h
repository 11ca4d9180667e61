#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/kinematics/model.h"
#include "core/packet/session_state.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Links at the ends of a model's chains, but for those that nothing moves: where joints add up.
std::vector<std::size_t> tipLinks(const Model& model);

/// A device's samples while a track is made, with what carries it at each.
struct CarriedTrack {
  std::string name;
  const Model* model = nullptr;
  DeviceTrack* track = nullptr;
  const std::vector<std::uint16_t>* carriers = nullptr;  ///< by sample, into the carriers' names
};

/// Adds the poses of tip links in the world to each device's rows, by the kinematics of the cell.
/// `carrier_names`: the first is the world. A carrier that is missing or carried in a loop counts
/// as the world.
void addLinkTracks(std::vector<CarriedTrack>& devices, const std::vector<Path>& carrier_names,
                   std::size_t samples);

}  // namespace rocinante
