#pragma once

#include <string>
#include <string_view>

namespace rocinante {

/// `text`, which is UTF-8, as a TOML string.
std::string tomlText(std::string_view text);

}  // namespace rocinante
