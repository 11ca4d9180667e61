#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/check/judges/tally.h"
#include "core/packet/packet.h"

namespace rocinante {

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
