#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

inline constexpr std::string_view kDefaultRecordName = "session-%Y%m%dT%H%M%SZ.mcap";

/// The path of a recording. `output` is a file, a folder (an existing one, or one that ends in a
/// slash: the default name in it), or either with strftime's %Y %m %d %H %M %S %j %F %s %%, filled
/// from `start` in UTC, and %n, the number of the piece, with three digits or more. Empty: the
/// default name in the current folder.
Result<std::filesystem::path> recordPath(std::string_view output, WallTime start,
                                         std::uint64_t number = 1);

/// The parts of the name that change from piece to piece.
struct ChangingName {
  bool number = false;  ///< %n
  bool time = false;
};
/// `output` must be accepted by recordPath().
ChangingName changingName(std::string_view output);

/// "logs/cell-002.mcap" for "logs/cell.mcap" and 2: as `rocinante log split` names pieces.
std::filesystem::path numberedPath(const std::filesystem::path& path, std::uint64_t number);

}  // namespace rocinante
