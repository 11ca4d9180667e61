#pragma once

#include <string_view>

#include "core/log/log_writer.h"

namespace rocinante {

/// --compression into `options`: "none", "zstd" or "zstd:LEVEL", 1 to 22. bad_argument otherwise.
Status readCompression(std::string_view text, LogWriterOptions& options);

}  // namespace rocinante
