#pragma once

#include <string>
#include <string_view>

namespace rocinante {

/// The media type of a file by the ending of its name; application/octet-stream when the ending is
/// unknown.
std::string mediaTypeOf(std::string_view name);

}  // namespace rocinante
