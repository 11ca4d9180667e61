#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/judges/tally.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Judges datagrams by the result of their decoder.
class DatagramJudge {
 public:
  void takeUndecoded(std::string_view encoding, const PacketPlace& place);
  void takeFaults(std::span<const FaultAt> faults, PacketPlace place);
  void takeNotFinite(const NotFiniteField& field, const PacketPlace& place);
  void report(Findings& findings) const;
  /// Forgets what was found.
  void dropFindings();

 private:
  std::array<Tally, kPacketFaultCount> faults_;
  std::array<std::uint32_t, kPacketFaultCount> columns_{};  ///< of the first
  /// Whether the word at the fault is nearly one of a statement; notes which.
  bool isMisspelt(ByteView datagram, const FaultAt& at);

  Tally not_finite_, misspelt_, no_unit_;
  std::string last_word_, meant_hint_, misspelt_word_, misspelt_hint_, unit_hint_;
  std::uint32_t not_finite_column_ = 0, unit_column_ = 0;
  using ByName = std::map<std::string, Tally, std::less<>>;
  ByName undecoded_;                                      ///< by encoding
  std::map<std::string, ByName, std::less<>> no_values_;  ///< fields, by source
};

}  // namespace rocinante
