#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/report/account.h"
#include "recorder/capture/input_loop.h"
#include "recorder/capture/tee.h"

namespace rocinante {

/// Counts of datagrams that an endpoint neither recorded nor lost, and whether its buffer was large
/// enough.
struct InputAccount {
  std::string endpoint;  ///< with the bound port
  InputCounts counts;
  std::optional<SubscriptionOutcome> subscription;  ///< empty: it is not one
  Account left_out;                                 ///< by kind: frames that became no datagram
  std::uint64_t buffer_granted_bytes = 0;           ///< 0: no receive buffer
  std::uint64_t buffer_needed_bytes = 0;            ///< to survive a stall in its busiest second
};

/// One per source. Not while the loop runs.
std::vector<InputAccount> inputAccounts(const std::vector<DatagramSource*>& sources,
                                        const InputLoop& loop);

}  // namespace rocinante
