#pragma once

#include <filesystem>
#include <string>

#include "core/copy/log_make.h"

namespace rocinante {

/// Copies the messages and times that `selection` names into a self-contained log. `reason` is the
/// tool's name. not_found when no captured message is chosen.
Result<CopyReport> cutLog(const std::filesystem::path& log, const SelectionOptions& selection,
                          const MakeOptions& make, const std::string& reason,
                          CopyAddition* addition = nullptr);

}  // namespace rocinante
