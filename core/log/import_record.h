#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/log/log_types.h"

namespace rocinante {

/// The metadata record of a log that was imported (docs/log-format.md): what could not be kept or
/// translated, a line each.
inline constexpr std::string_view kImportRecord = "rocinante.import";
inline constexpr std::string_view kImportWarningsKey = "warnings";
/// What became no packet: accountLines() of core/report/account.h.
inline constexpr std::string_view kImportLeftOutKey = "left_out";

/// The reason in rocinante.end of a log that an import made.
inline constexpr std::string_view kImportedEnd = "rocinante log import";

bool hasImportRecord(const std::vector<LogMetadata>& metadata);
/// The lines of such a record among `metadata`, as plain text; empty when there is none.
std::vector<std::string> importWarningsOf(const std::vector<LogMetadata>& metadata);
/// Those of `left_out`; empty when nothing was, or there is no such record.
std::string importLeftOutOf(const std::vector<LogMetadata>& metadata);

}  // namespace rocinante
