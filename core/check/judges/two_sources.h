#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/judges/tally.h"

namespace rocinante {

/// Counts how often what one source wrote last is written by another.
struct TwoSources {
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  Tally tally;
  std::uint32_t before = kNobody, now = kNobody;  ///< numbers of the first two sources

  /// `writer`: the last, kNobody before the first; becomes the one of `place`.
  void note(std::uint32_t& writer, const PacketPlace& place);
  /// `what` of the device they write: "joints"; `sources`: names by number.
  void report(const std::string& device, std::string_view what,
              const std::vector<std::string>& sources, Findings& findings) const;
};

}  // namespace rocinante
