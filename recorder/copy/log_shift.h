#pragma once

#include <filesystem>
#include <string>

#include "recorder/copy/log_make.h"

namespace rocinante {

struct ShiftOptions {
  std::string by;        ///< a duration; or
  std::string to;        ///< RFC 3339: when the session's origin shall have been
  bool publish = false;  ///< the senders' times too
};

/// The log at another time. bad_argument when a time would lie before 1970 or beyond 2262.
Result<CopyReport> shiftLog(const std::filesystem::path& log, const ShiftOptions& shift,
                            const MakeOptions& make);

}  // namespace rocinante
