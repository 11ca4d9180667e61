#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// A source of a live session, as its row shows it.
struct LiveSource {
  std::string name;
  double rate_hz = 0;              ///< packets in the last second
  SteadyTime heard{};              ///< when its last packet came, to a tenth of a second
  std::uint64_t packets = 0;       ///< applied or late
  std::uint64_t lost = 0;          ///< sequence numbers never seen
  std::uint64_t late = 0;          ///< dropped: behind newer ones, duplicates among them
  std::uint64_t restarts = 0;      ///< it began anew
  std::uint64_t faulty_lines = 0;  ///< that could not be read, of all its packets
  bool operator==(const LiveSource&) const = default;
};

/// Turns the fold's counts, looked at ten times a second, into rates and silences: nothing is paid
/// for by the packet. A plain value.
class SourceWatch {
 public:
  /// Every source by name. Cheap until a tenth of a second has passed since the last look; true
  /// when sources() became another.
  bool look(SteadyTime now, const std::map<std::string, SourceCounts, std::less<>>& counts);
  const std::vector<LiveSource>& sources() const { return sources_; }

 private:
  static constexpr std::size_t kTenths = 10;
  struct Watched {
    std::array<std::uint64_t, kTenths> packets{};  ///< at the last looks, as a ring
    SteadyTime heard{};
    SteadyTime since{};
  };

  std::map<std::string, Watched, std::less<>> watched_;
  std::vector<LiveSource> sources_;
  std::optional<SteadyTime> looked_;
  std::array<SteadyTime, kTenths> times_{};
  std::size_t next_ = 0;
};

}  // namespace rocinante
