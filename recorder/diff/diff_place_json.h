#pragma once

#include <optional>

#include "core/report/json_text.h"
#include "recorder/diff/log_diff.h"

namespace rocinante {

/// One message of a log; null when the log has ended before.
Json placeJson(const std::optional<DiffPlace>& place);

}  // namespace rocinante
