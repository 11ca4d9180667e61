#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Writes folder/index.html, report.json, page-pictures.json and, for each frame that is not fine,
/// NAME.frame.png, NAME.golden.png and NAME.difference.png, and of all of them differences.png
/// (DifferenceSheet); for each run that is different, NAME.run-1.png and so on. Creates the folder.
/// All files are written aside first: on an error the old report stays intact. Pictures of the old
/// report that the new one does not have are removed.
Status writeReport(const SuiteReport& report, const std::filesystem::path& folder);

}  // namespace rocinante
