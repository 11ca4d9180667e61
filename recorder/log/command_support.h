#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/cli/progress_line.h"

namespace rocinante {

using cli::ProgressLine;

/// A TextSink that writes all of `text` to standard output, or fails.
Status toStandardOutput(std::string_view text);

}  // namespace rocinante
