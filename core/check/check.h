#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/log/log_reader.h"
#include "core/packet/packet.h"

namespace rocinante {

/// The cell alone: its faults and those of all files that it names. Compatible without an error.
CheckReport checkCell(const Cell& cell);

/// What a decoder makes of captured octets. Borrowed until the next call.
struct DecodedOctets {
  std::string_view packet;  ///< empty: none
  std::span<const NotFiniteField> not_finite;
};
/// `has_packet`: the log has a channel of packets that were made of such octets, and only the
/// fields are asked for.
using OctetPackets = std::function<DecodedOctets(const LogMessage&, bool has_packet)>;

/// The cell and a whole recorded session. nothing_judged when no packet of it can be decoded.
/// `packets` is asked for all octets.
/// `progress` is called now and then with the finished part, 0 to 1; when it returns false, judging
/// stops and the report says that it was interrupted.
Result<CheckReport> checkLog(const Cell& cell, LogReader& log,
                             const std::function<bool(double)>& progress = {},
                             const OctetPackets& packets = {});

}  // namespace rocinante
