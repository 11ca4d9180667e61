#pragma once

#include <filesystem>
#include <vector>

#include "recorder/copy/log_make.h"

namespace rocinante {

/// Several logs as one. Those of one session stay that session, and what several of them hold is
/// taken once; else a new one, named by theirs. Times count from the earliest origin. At one time
/// the log named first comes first, and of pieces of one session the one that begins first.
Result<CopyReport> mergeLogs(const std::vector<std::filesystem::path>& logs,
                             const MakeOptions& make);

}  // namespace rocinante
