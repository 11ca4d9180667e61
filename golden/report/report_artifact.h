#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// What a job kept of `golden run --report`, as a service of CI hands it out: a folder, or a ZIP
/// file, with the report somewhere in it.
/// not_found when nothing in it is a report; refused when it has several; damaged when a picture is
/// not the one that its report.json lists. From a ZIP file only the report, the pictures that were
/// drawn and the logs of runs are read.
Result<SuiteReport> readArtifact(const std::filesystem::path& artifact);

}  // namespace rocinante
