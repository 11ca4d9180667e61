#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/cli/progress_line.h"

namespace rocinante {

using cli::ProgressLine;

/// A TextSink: all of `text` goes to standard output, or it is an error.
Status toStandardOutput(std::string_view text);

}  // namespace rocinante
