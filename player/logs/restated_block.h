#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"
#include "player/logs/play_routes.h"

namespace rocinante {

/// One datagram of a restatement, and by which socket it leaves.
struct RestatedDatagram {
  std::string text;
  std::uint16_t route = 0;
};

/// What a player says so that every receiver has `state` whatever it knew: by=player, reset, of
/// every source of the state, then of those of `sources` that have not spoken by then
/// (docs/packet-format.md, "Restatements"). `part_id` is to be another one each time: a part that
/// was lost must not be made up for by the next one's.
std::vector<RestatedDatagram> restatedBlock(const SessionState& state,
                                            const std::set<std::string>& sources,
                                            const PlayRoutes& routes, std::string_view part_id);

}  // namespace rocinante
