#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Writes folder/index.html, report.json, page-pictures.json and, for each frame that is not fine,
/// NAME.frame.png, NAME.golden.png and NAME.difference.png. The folder is made. All of it is
/// written aside first: on an error the folder's old report stands, whole. Pictures of the old
/// one that the new one does not have go.
Status writeReport(const SuiteReport& report, const std::filesystem::path& folder);

}  // namespace rocinante
