#pragma once

#include <string_view>

#include "core/check/rules/check_report.h"

namespace rocinante {

/// True for a rule that judges a session by itself: those of packets, signals, sources and the log,
/// but for what compares a packet with a cell.
bool judgesWithoutCell(std::string_view rule);

/// For a report of a session that was judged with an empty cell since there is none: leaves out the
/// findings of the other rules, and says of them that they had nothing to judge. Concludes it.
void concludeWithoutCell(CheckReport& report);

/// One sentence of what such a report has not judged.
std::string_view withoutCellSentence();

}  // namespace rocinante
