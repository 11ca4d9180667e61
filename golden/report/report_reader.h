#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Reads a report written by `run --report DIR`: the frames with their figures, and the pictures of
/// those that were not fine. damaged, with the file, when it is not such a report.
Result<SuiteReport> readReport(const std::filesystem::path& folder);
/// The same from the text of report.json, without pictures; `file` is used in messages.
Result<SuiteReport> parseReport(std::string_view text, const std::filesystem::path& file);

/// What a job kept of `golden run --report`, as a service of CI hands it out: a folder, or a ZIP
/// file, with the report somewhere in it.
/// not_found when nothing in it is a report; refused when it has several; damaged when a picture is
/// not the one that its report.json lists. From a ZIP file only the report, the pictures that were
/// drawn and the logs of runs are read.
Result<SuiteReport> readArtifact(const std::filesystem::path& artifact);

/// Merges reports: all shards of one run, or runs of several suites. refused when a shard is
/// missing or given twice, when two reports have a frame of the same name, and when shards of one
/// run have different sessions or renderers.
Result<SuiteReport> mergeReports(std::vector<SuiteReport> parts);

}  // namespace rocinante
