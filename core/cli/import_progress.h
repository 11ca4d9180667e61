#pragma once

#include <functional>
#include <string>

#include "core/base/result.h"

namespace rocinante::cli {

/// The progress callback for importing another program's recording: a ProgressLine that says
/// "importing NAME 42 %", and an error once the user asked to stop. The line disappears with the
/// last copy of the callback.
std::function<Status(double)> importProgress(const std::string& name);

}  // namespace rocinante::cli
