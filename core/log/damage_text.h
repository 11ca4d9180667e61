#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/log/log_types.h"

namespace rocinante {

/// "the chunk fails its checksum (half.mcap, byte 1048620)": as an error about that place prints.
std::string damageText(std::string_view cause, std::string_view file, std::uint64_t byte);
inline std::string damageText(const DamageSpan& span, std::string_view file) {
  return damageText(span.cause, file, span.from);
}

}  // namespace rocinante
