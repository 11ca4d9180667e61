#pragma once

#include <filesystem>
#include <vector>

#include "core/copy/log_make.h"

namespace rocinante {

/// Merges several logs. Pieces of one session give that session, and shared messages are taken
/// once; different sessions give a new one whose id is derived from theirs. Times count from the
/// earliest origin. At equal times the log named first comes first, and among pieces of one session
/// the one that begins first.
Result<CopyReport> mergeLogs(const std::vector<std::filesystem::path>& logs,
                             const MakeOptions& make);

}  // namespace rocinante
