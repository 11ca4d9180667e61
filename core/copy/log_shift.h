#pragma once

#include <filesystem>
#include <string>

#include "core/copy/log_make.h"

namespace rocinante {

struct ShiftOptions {
  std::string by;        ///< a duration; or
  std::string to;        ///< RFC 3339: the new origin of the session
  bool publish = false;  ///< move the senders' times too
};

/// Moves a log in time. bad_argument when a time would be before 1970 or after 2262.
Result<CopyReport> shiftLog(const std::filesystem::path& log, const ShiftOptions& shift,
                            const MakeOptions& make);

}  // namespace rocinante
