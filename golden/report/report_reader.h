#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Reads a report written by `run --report DIR`: the frames with their figures, and the pictures of
/// those that were not fine. damaged, with the file, when it is not such a report.
Result<SuiteReport> readReport(const std::filesystem::path& folder);
/// The same from the text of report.json, without pictures; `file` is used in messages.
Result<SuiteReport> parseReport(std::string_view text, const std::filesystem::path& file);

}  // namespace rocinante
