#pragma once

#include <string_view>

/// The names of the MCAP profile `rocinante` (docs/log-format.md).
namespace rocinante::profile {

inline constexpr std::string_view kName = "rocinante";
inline constexpr std::string_view kSession = "rocinante.session";  ///< metadata
inline constexpr std::string_view kEnd = "rocinante.end";          ///< metadata
inline constexpr std::string_view kFormatKey = "format";
inline constexpr std::string_view kFormat = "1";
inline constexpr std::string_view kSessionIdKey = "session_id";
inline constexpr std::string_view kOriginKey = "origin_ns";
inline constexpr std::string_view kReasonKey = "reason";

}  // namespace rocinante::profile
