#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rocinante {

/// "1 frame", "2000 frames". cli::counted() groups the digits, for tables and summaries.
std::string countText(std::uint64_t number, std::string_view one);

}  // namespace rocinante
