#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Where a page opens: "#t=12.5&camera=overview&select=arm/link4", to be appended to its address.
/// Seconds count from the session's origin. What is empty is left out; of `select` the second part
/// may be.
std::string pageLink(std::optional<Nanoseconds> moment, std::string_view camera,
                     const Path& select);

}  // namespace rocinante
