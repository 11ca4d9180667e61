#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "player/logs/multi_log_reader.h"
#include "player/send/datagram_stream.h"

namespace rocinante {

/// The part of the logs from `from` until `until`, session times (core/session/session_time.h);
/// empty: everything. Begins at the first captured message at the earliest. bad_argument when a
/// time cannot be parsed; may hold no message.
Result<PlayedSpan> playedSpan(const MultiLogReader& logs, const std::optional<std::string>& from,
                              const std::optional<std::string>& until);

}  // namespace rocinante
