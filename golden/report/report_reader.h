#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// What `run --report DIR` left in a folder, as a report again: the frames with their figures, and
/// the pictures of those that were not fine. damaged, with the file, for what is no such report.
Result<SuiteReport> readReport(const std::filesystem::path& folder);
/// The same from the text of report.json, without pictures; `file` is for the sentences.
Result<SuiteReport> parseReport(std::string_view text, const std::filesystem::path& file);

}  // namespace rocinante
