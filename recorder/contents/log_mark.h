#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/packet/session_state.h"

namespace rocinante {

struct MarkMade {
  Event mark;
  LogTime origin{};  ///< the log's
};

/// Adds a mark to LOG.marks at the session time `time` ("12.5s", "-1s", RFC 3339). The log is read,
/// never written. bad_argument when the time is invalid or outside the log.
Result<MarkMade> markLog(const std::filesystem::path& log, std::string_view time, std::string text);

}  // namespace rocinante
