#pragma once

#include <string_view>

namespace rocinante {

/// Whether `name` is what `pattern` describes: `*` is any run of bytes, `?` any one byte, all else
/// itself. Takes time in proportion to the product of both lengths at worst.
bool globMatches(std::string_view pattern, std::string_view name);

}  // namespace rocinante
