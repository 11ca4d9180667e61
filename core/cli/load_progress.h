#pragma once

#include <string>

#include "core/base/parallel_for.h"

namespace rocinante::cli {

/// What a program hands to whatever loads files (CellOptions::progress): a ProgressLine that says
/// "loading NAME 42 %", by bytes, and goes when all that is known of is there.
TellLoadProgress loadProgress(const std::string& name);

}  // namespace rocinante::cli
