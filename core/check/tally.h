#pragma once

#include <cstdint>
#include <string>

#include "core/bytes.h"
#include "core/check/finding.h"
#include "core/time.h"

namespace rocinante {

/// Which statement is being judged. Borrowed from the packet.
struct Place {
  LogTime time{};
  std::uint64_t packet = 0;  ///< captured datagrams from 1
  ByteView datagram;
  std::uint32_t line = 0;  ///< in the datagram, from 1
};

/// How often something happened, when, and its first example. Counting allocates only the first
/// time: a session whose every packet is wrong is judged as fast as a sound one.
struct Tally {
  std::uint64_t count = 0;
  LogTime first{}, last{};
  TimeHistogram when;
  std::uint64_t packet = 0;
  std::string example;

  /// True the first time.
  bool hit(const Place& place);
  /// A finding with what was counted.
  Finding finding(std::string rule, Severity severity, std::string subject, std::string text) const;
};

}  // namespace rocinante
