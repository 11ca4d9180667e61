#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "recorder/doctor/doctor_report.h"

namespace rocinante {

/// Checks a file against every rule of the MCAP format and, for our logs, of the profile
/// (docs/programs/log.md, "log doctor"). Reads the whole file, holding one chunk in memory at a
/// time. damaged when the file does not begin as an MCAP file, so that nothing can be judged.
/// `progress` is called with the fraction done, 0 to 1.
Result<DoctorReport> examineLog(const std::filesystem::path& path,
                                const std::function<void(double)>& progress = {});
/// The same for bytes in memory.
Result<DoctorReport> examineBytes(ByteView file, std::string name,
                                  const std::function<void(double)>& progress = {});

/// One line per breach for the user, each with LF.
std::string doctorText(const DoctorReport& report);
/// One JSON object for scripts, indented or on one line, with LF.
std::string doctorJson(const DoctorReport& report, bool indented);

}  // namespace rocinante
