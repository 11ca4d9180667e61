#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "recorder/doctor/doctor_report.h"

namespace rocinante {

/// Holds a file against every rule of the MCAP format and, where it is ours, of the profile
/// (docs/programs/log.md, "log doctor"). All of it is read; one chunk is held in memory at a time.
/// damaged when it does not begin as an MCAP file does: then there is nothing to judge. `progress`
/// is told now and then which part is done, 0 to 1.
Result<DoctorReport> examineLog(const std::filesystem::path& path,
                                const std::function<void(double)>& progress = {});
/// The same of bytes in memory.
Result<DoctorReport> examineBytes(ByteView file, std::string name,
                                  const std::function<void(double)>& progress = {});

/// For people: a line a breach, the last with its LF.
std::string doctorText(const DoctorReport& report);
/// For scripts: one JSON object, indented or on one line, with its LF.
std::string doctorJson(const DoctorReport& report, bool indented);

}  // namespace rocinante
