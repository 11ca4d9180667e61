#pragma once

#include <filesystem>
#include <string>

#include "golden/report/report.h"

namespace rocinante {

/// Lines by which CTest uploads the pictures of the frames that are not fine, as writeReport() left
/// them in `folder`: frame, golden and difference. CDash compares those of the first frame; the
/// others, whose roles end in their name, are shown beside them.
std::string reportCdash(const SuiteReport& report, const std::filesystem::path& folder);

}  // namespace rocinante
