#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"
#include "player/logs/play_routes.h"

namespace rocinante {

/// One datagram of a restatement, and its route.
struct RestatedDatagram {
  std::string text;
  std::uint16_t route = 0;
};

/// The player's datagrams that give every receiver `state`, regardless of what it knew: by=player,
/// reset, for every source of the state, then for those of `sources` that have not sent yet
/// (docs/packet-format.md, "Restatements"). `part_id` must differ each time: a part of the next
/// restatement must not replace a lost one of this. A datagram holds at most `mtu_bytes`, unless
/// one statement is larger.
std::vector<RestatedDatagram> restatedBlock(const SessionState& state,
                                            const std::set<std::string>& sources,
                                            const PlayRoutes& routes, std::string_view part_id,
                                            std::size_t mtu_bytes);

}  // namespace rocinante
