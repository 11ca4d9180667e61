#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cli/progress_line.h"

namespace rocinante {

using cli::ProgressLine;

/// A TextSink that writes all of `text` to standard output, or fails.
Status toStandardOutput(std::string_view text);

/// The time between the moments of `--every`, which is above 0 and gives at most `most` of them in
/// a span: a clock that was set while it was recorded makes one of 50 years.
Result<Nanoseconds> readEvery(const std::string& text, Nanoseconds span, std::int64_t most);

}  // namespace rocinante
