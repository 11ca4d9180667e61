#pragma once

#include <filesystem>
#include <string>

#include "recorder/copy/log_make.h"

namespace rocinante {

/// The part of a log that `selection` names, its times included, as a log that stands alone.
/// `reason` is the tool's name. not_found when no captured message is chosen.
Result<CopyReport> cutLog(const std::filesystem::path& log, const SelectionOptions& selection,
                          const MakeOptions& make, const std::string& reason);

}  // namespace rocinante
