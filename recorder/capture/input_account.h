#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/net/datagram_source.h"
#include "recorder/capture/receive_loop.h"
#include "recorder/capture/tee.h"

namespace rocinante {

/// What came to an endpoint and is neither recorded nor lost, and whether its buffer was enough.
struct InputAccount {
  std::string endpoint;  ///< with the port that was bound
  InputCounts counts;
  std::uint64_t buffer_granted_bytes = 0;  ///< 0: it has none of this kind
  std::uint64_t buffer_needed_bytes = 0;   ///< for a stall in its busiest second
};

/// By source. Not while the loop runs.
std::vector<InputAccount> inputAccounts(const std::vector<DatagramSource*>& sources,
                                        const ReceiveLoop& loop);

}  // namespace rocinante
