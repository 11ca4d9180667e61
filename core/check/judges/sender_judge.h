#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/judges/tally.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Counts how often what one source wrote last is written by another.
struct TwoSources {
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  Tally tally;
  std::uint32_t before = kNobody, now = kNobody;  ///< numbers of the first two sources

  /// `writer`: the last, kNobody before the first; becomes the one of `place`.
  void note(std::uint32_t& writer, const PacketPlace& place);
  /// `what` they write: "the joints of device arm are"; `sources`: names by number.
  void report(const std::string& subject, std::string_view what,
              const std::vector<std::string>& sources, Findings& findings) const;
};

/// Detects two processes that send as one source: a RUN that another has followed is heard again
/// soon after, several times. A restart leaves its old RUN for good, and a replay that begins anew
/// says so (`reset`). Allocates only for a RUN that was not heard lately.
class SenderJudge {
 public:
  /// The next packet of the source, or a restatement of another program.
  void take(const PacketHeader& header, const PacketPlace& place);
  bool found() const { return returns_.count > 0 && all_returns_ >= kReturns; }
  void report(const std::string& source, Findings& findings) const;
  /// Forgets what was found; the runs are followed on.
  void dropFindings();

 private:
  /// Fewer may be packets that were overtaken at a restart.
  static constexpr std::uint64_t kReturns = 3;
  /// A running source sends at least its restatement this often.
  static constexpr Nanoseconds kSoon = std::chrono::seconds(3);

  struct Run {
    std::string run, sender;
    LogTime last{};
    bool is_set = false;
  };

  Run now_;
  std::array<Run, 3> earlier_;  ///< the latest first
  Tally returns_;
  std::uint64_t all_returns_ = 0;
  std::string runs_;  ///< of the first return, and who sends them
};

}  // namespace rocinante
