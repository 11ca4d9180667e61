#pragma once

#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace rocinante {

inline constexpr std::string_view kClockTopic = "/rocinante/clock";

/// A message on /rocinante/clock with its log time moved. Empty when the payload is none.
std::optional<std::string> shiftedClockText(ByteView payload, Nanoseconds shift);

}  // namespace rocinante
