#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// A source of a live session, for its row.
struct LiveSource {
  std::string name;
  double rate_hz = 0;              ///< packets in the last second
  SteadyTime heard{};              ///< when its last packet came, to a tenth of a second
  std::uint64_t packets = 0;       ///< applied or late
  std::uint64_t lost = 0;          ///< sequence numbers never seen
  std::uint64_t late = 0;          ///< dropped: older than received ones, or duplicates
  std::uint64_t restarts = 0;      ///< times it restarted
  std::uint64_t faulty_lines = 0;  ///< unreadable lines of all its packets
  bool is_mixed = false;           ///< heard whole and also filtered by a relay
  bool operator==(const LiveSource&) const = default;
};

/// Converts the fold's counts, sampled ten times a second, into rates and silences, without a cost
/// per packet. A plain value.
class SourceWatch {
 public:
  /// Samples every source by name. Cheap until a tenth of a second has passed since the last
  /// sample; true when sources() changed.
  bool look(SteadyTime now, const std::map<std::string, SourceCounts, std::less<>>& counts);
  const std::vector<LiveSource>& sources() const { return sources_; }

 private:
  static constexpr std::size_t kTenths = 10;
  struct Watched {
    std::array<std::uint64_t, kTenths> packets{};  ///< of the last samples, as a ring
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
