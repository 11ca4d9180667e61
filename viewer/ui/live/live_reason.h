#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/net/datagram_source.h"
#include "core/net/endpoint.h"
#include "core/report/finding.h"

namespace rocinante {

/// Facts about a live session, for explaining why nothing moves.
struct LiveFacts {
  std::vector<Endpoint> endpoints;
  Nanoseconds watched{};  ///< since listening began
  /// Since the last datagram of a machine, that is of no other window; or since listening began.
  Nanoseconds silent{};
  std::uint64_t datagrams = 0;
  std::uint64_t undecoded = 0;   ///< of those: not packets
  std::string undecoded_sample;  ///< the beginning of the first of them, printable
  UntrustedCounts untrusted;     ///< refused by --trust; not among `datagrams`
  std::size_t devices_spoken_of = 0;
  bool only_windows = false;   ///< every source is another window's, or says where one looks
  bool any_window = false;     ///< one of them is such a source, and has not left
  std::string news;            ///< what a source said last about receiving; may be empty
  std::string unknown_device;  ///< one of them, when the cell has none of them
};

/// Why nothing moves; empty when there is no problem or it is too early to say. Pure.
std::optional<Finding> liveReason(const LiveFacts& facts);

}  // namespace rocinante
