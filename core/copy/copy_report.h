#pragma once

#include <string>
#include <vector>

#include "core/copy/log_copy.h"
#include "core/copy/log_split.h"

namespace rocinante {

/// One JSON object for scripts, with LF (docs/programs/log.md).
std::string copyReportJson(const std::string& output, const CopyReport& report);
std::string splitReportJson(const SplitReport& report);
/// The same with `recovered` and `lost`.
std::string recoverReportJson(const std::string& output, const CopyReport& report);

/// For the user: "piece.mcap: 1200 messages of 3 channels, 2.000 s", with LF.
std::string copyReportText(const std::string& output, const PieceCounts& counts);

/// "bytes 600 to 720 of session.mcap: chunk 3 fails its checksum (12 messages lost)".
std::string gapText(const CopyGap& gap);

}  // namespace rocinante
