#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/hash.h"
#include "core/base/result.h"

namespace rocinante {

/// Called with the part that is done, 0 to 1; an error ends the work.
using DigestProgress = std::function<Status(double)>;

/// Adds all bytes of a file, and before them their number. Memory does not grow with the file.
/// not_found or unreadable.
Status addFile(Sha256& hash, const std::filesystem::path& path, const DigestProgress& progress);

/// "BYTES SUM" with LF: tells a file that was damaged by accident, as fast as it can be read.
Result<std::string> quickSumOf(const std::filesystem::path& path);

}  // namespace rocinante
