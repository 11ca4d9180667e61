#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/foreign/decode/decode_account.h"
#include "core/net/datagram_source.h"
#include "core/relay/relay.h"
#include "core/subscription/subscription_desk.h"

namespace rocinante {

/// What a relay did (docs/programs/relay.md).
struct RelayReport {
  struct Input {
    std::string endpoint;
    std::uint64_t datagrams = 0, dropped = 0;
    InputCounts counts;
  };
  struct Output {
    std::string endpoint;  ///< of subscribers: the address
    std::string number;    ///< OUTPUT
    bool whole = true;
    std::uint64_t forwarded = 0, dropped = 0;
    std::uint64_t conflated = 0;  ///< values that newer ones replaced before they were sent
    FilteredOutCounts filtered_out{};
    PacedCounts paced{};    ///< events and changes, which wait for a slow link
    std::string trouble{};  ///< the first refusal of the system
  };
  std::string name, run;
  std::vector<Input> inputs;
  std::vector<Output> outputs;  ///< each `to`
  RelayInputCounts counts;
  std::optional<RelayLoop> loop;                        ///< the first sign of one
  std::uint64_t subscribers = 0, most_subscribers = 0;  ///< at the end, and at any time
  std::uint64_t served = 0, served_dropped = 0;         ///< datagrams to subscribers
  std::uint64_t served_conflated = 0;                   ///< values
  FilteredOutCounts served_filtered_out;
  PacedCounts served_paced;  ///< events and changes
  SubscriptionDesk::Counts requests;
  std::optional<decode::DecodeAccount> decoded;  ///< empty without decoders
  std::string scheduling;                        ///< "fifo" or "other"
  double seconds = 0;

  /// Datagrams that were lost on the way in or out, as far as this machine knows.
  std::uint64_t lost() const;
};

/// As JSON, with a line end. `format` comes first.
std::string jsonText(const RelayReport& report);
/// In a few lines for the user.
std::string summaryText(const RelayReport& report);

}  // namespace rocinante
