#pragma once

#include <string>

#include "core/base/parallel_for.h"

namespace rocinante::cli {

/// The progress callback for loading files (CellOptions::progress): a ProgressLine that says
/// "loading NAME 42 %", by bytes, and disappears when everything known is loaded.
TellLoadProgress loadProgress(const std::string& name);

}  // namespace rocinante::cli
