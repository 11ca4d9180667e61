#pragma once

#include <filesystem>
#include <string_view>

#include "core/result.h"
#include "core/time.h"

namespace rocinante {

inline constexpr std::string_view kDefaultRecordName = "session-%Y%m%dT%H%M%SZ.mcap";

/// Where a recording goes. `output` is a file, a folder (an existing one, or one that ends in a
/// slash: the default name in it), or either with strftime's %Y %m %d %H %M %S %j %F %s %%, filled
/// from `start` in UTC. Empty: the default name here.
Result<std::filesystem::path> recordPath(std::string_view output, WallTime start);

}  // namespace rocinante
