#pragma once

#include <functional>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// The cell alone: its faults and those of all files that it names. Compatible without an error.
CheckReport checkCell(const Cell& cell);

/// The packet that a decoder makes of captured octets; empty for none. Borrowed until the next
/// call.
using OctetPackets = std::function<std::string_view(const LogMessage&)>;

/// The cell and a whole recorded session. nothing_judged when no packet of it can be decoded.
/// `packets` is asked for octets on topics for which the log has no decoded packets.
/// `progress` is called now and then with the finished part, 0 to 1; when it returns false, judging
/// stops and the report says that it was interrupted.
Result<CheckReport> checkLog(const Cell& cell, LogReader& log,
                             const std::function<bool(double)>& progress = {},
                             const OctetPackets& packets = {});

}  // namespace rocinante
