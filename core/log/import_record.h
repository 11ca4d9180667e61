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

/// The lines of such a record among `metadata`, as plain text; empty when there is none.
std::vector<std::string> importWarningsOf(const std::vector<LogMetadata>& metadata);

}  // namespace rocinante
