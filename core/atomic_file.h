#pragma once

#include <filesystem>
#include <string>

#include "core/bytes.h"
#include "core/result.h"

namespace rocinante {

/// A whole file in memory: at most `max_bytes`, checked before anything is allocated.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::uint64_t max_bytes = std::uint64_t{1} << 31);

/// Writes beside `path`, syncs and renames: the file appears whole or not at all. refused when it
/// exists and `overwrite` is false.
Status writeFileWhole(const std::filesystem::path& path, ByteView bytes, bool overwrite);

}  // namespace rocinante
