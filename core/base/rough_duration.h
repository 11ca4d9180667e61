#pragma once

#include <string>

#include "core/base/time.h"

namespace rocinante {

/// For sentences about long times: "53.9 years", "3.4 days", "2.0 hours", "75 s".
std::string roughDuration(Nanoseconds duration);

}  // namespace rocinante
