#pragma once

#include <string>
#include <string_view>

namespace rocinante {

/// The media type of a file by the ending of its name; application/octet-stream where that says
/// nothing.
std::string mediaTypeOf(std::string_view name);

}  // namespace rocinante
