#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// What is known of a live session in which little is to be seen.
struct LiveFacts {
  std::vector<Endpoint> endpoints;
  Nanoseconds watched{};  ///< since listening began
  Nanoseconds silent{};   ///< since the last datagram, or since listening began
  std::uint64_t datagrams = 0;
  std::uint64_t undecoded = 0;   ///< of those: no packets
  std::string undecoded_sample;  ///< the beginning of the first of them, printable
  std::size_t devices_spoken_of = 0;
  std::string unknown_device;  ///< one that the cell does not have, when it has none of them
};

struct LiveReason {
  std::string what;  ///< one sentence
  std::string hint;  ///< what to look at; may be empty
};

/// Why nothing moves, in the words of `rocinante spy`; empty while all is well or it is too early
/// to say. Pure.
std::optional<LiveReason> liveReason(const LiveFacts& facts);

}  // namespace rocinante
