#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/report/finding.h"

namespace rocinante {

/// The statement being judged, its sender and time. Borrowed from the packet.
struct PacketPlace {
  LogTime time{};            ///< arrival
  std::uint64_t packet = 0;  ///< captured datagrams from 1
  ByteView datagram;
  std::string_view sender;  ///< its address and port; empty: not known
  /// Of a packet that a decoder or an import made: what it writes first, which tells the publishers
  /// of one topic apart. Empty: the source itself.
  std::string_view publisher;
  std::uint32_t line = 0;               ///< in the datagram, from 1
  std::uint64_t sequence = 0;           ///< SEQUENCE; 0 where there is none
  std::optional<std::int64_t> sent_ns;  ///< TIME: nanoseconds since the epoch on its clock
  std::uint32_t source = 0;             ///< number of the source
  std::uint32_t stretch = 0;            ///< changes at each restart and each `reset`
  bool is_restated = false;             ///< a restatement, by the source or by another program
};

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
