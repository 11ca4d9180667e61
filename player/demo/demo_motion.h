#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// The information sources of the demo cell (examples/demo). Each is one SOURCE of packet text.
enum class DemoPart : std::uint8_t {
  arm,      ///< the six joint values of `arm`, 100 Hz
  gantry,   ///< the joint values of `gantry`, 50 Hz, and the pose of the canister that it carries
  planner,  ///< the arm's path as drawings, two events, a shared view
};
inline constexpr DemoPart kDemoParts[] = {DemoPart::arm, DemoPart::gantry, DemoPart::planner};

/// The SOURCE of a part: "arm", "gantry", "planner".
std::string_view nameOf(DemoPart part);

/// One turn of the motion. The next turn may follow at once: it begins as the first one did.
inline constexpr Nanoseconds kDemoLength = std::chrono::seconds(20);

struct DemoOptions {
  std::int64_t epoch_ns = 0;  ///< TIME of the motion's zero, nanoseconds since the epoch
  std::string run;            ///< RUN token; empty: no RUN
  std::uint64_t turn =
      0;  ///< for endless demos: SEQUENCE, TIME and `at` continue from turn to turn
  std::size_t mtu_bytes = 1200;  ///< largest datagram; values under 512 count as 512
};

/// One datagram, and when it is due after the motion's zero.
struct DemoDatagram {
  Nanoseconds at{};  ///< turn * kDemoLength <= at < (turn + 1) * kDemoLength
  DemoPart part = DemoPart::arm;
  std::string payload;
};

/// All datagrams of one turn of `parts`, in order of `at` (ties: in order of DemoPart). A pure
/// function of its arguments, with the same bytes on every CPU. Each part sends everything with its
/// first datagram, changes at once, and restates all it owns every 2 s.
std::vector<DemoDatagram> demoDatagrams(const std::vector<DemoPart>& parts,
                                        const DemoOptions& options);

}  // namespace rocinante
