#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/check/judges/packet_place.h"
#include "core/report/finding.h"

namespace rocinante {

/// A finding of a rule, with its default severity.
Finding makeFinding(std::string_view rule, std::string subject, std::string text);

/// A value as sentences state it, with six significant digits, for Finding::worst; empty when it is
/// not finite.
std::optional<double> statedValue(double value);

/// How often something happened, when, and its first example. Only the first hit allocates: a
/// session in which every packet is wrong is judged as fast as a valid one.
struct Tally {
  std::uint64_t count = 0;
  LogTime first{}, last{};
  TimeHistogram when;
  std::uint64_t packet = 0;
  std::string example;

  /// True the first time.
  bool hit(const PacketPlace& place);
  /// Adds the counts of another.
  void merge(const Tally& other);
  /// A finding with these counts.
  Finding finding(std::string_view rule, std::string subject, std::string text) const;
};

}  // namespace rocinante
