#pragma once

#include <filesystem>
#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// The message for a file that is not a log: that it is empty, or does not start with the MCAP
/// magic; and if its first bytes are those of a capture, an archive or a bag, what it is and what
/// to do.
std::string notALog(ByteView file);

/// The message for what is not a regular file.
std::string notAFile(const std::filesystem::path& path);

/// The message for a file that `rocinante log import` cannot read.
std::string notImportable(ByteView first_bytes);

}  // namespace rocinante
