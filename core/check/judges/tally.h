#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/check/judges/packet_place.h"
#include "core/check/rules/finding.h"

namespace rocinante {

/// A finding of a rule, as severe as the list of rules says.
Finding makeFinding(std::string_view rule, std::string subject, std::string text);

/// How often something happened, when, and its first example. Counting allocates only the first
/// time: a session whose every packet is wrong is judged as fast as a sound one.
struct Tally {
  std::uint64_t count = 0;
  LogTime first{}, last{};
  TimeHistogram when;
  std::uint64_t packet = 0;
  std::string example;

  /// True the first time.
  bool hit(const PacketPlace& place);
  /// Adds what another counted.
  void merge(const Tally& other);
  /// A finding with what was counted.
  Finding finding(std::string_view rule, std::string subject, std::string text) const;
};

}  // namespace rocinante
