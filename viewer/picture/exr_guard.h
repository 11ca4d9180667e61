#pragma once

#include <cstdint>
#include <string_view>

namespace rocinante {

/// What is wrong with an OpenEXR file before the library sees it, as a sentence's end; empty:
/// nothing, or it is no OpenEXR. An attribute longer than the file, for all of which the library
/// would make memory first, up to 2 GiB; a channel of an unknown type, at which OpenImageIO ends
/// the program. `head` is how the file begins, of `file_bytes` in all; what lies behind the head is
/// not looked at. https://openexr.com/en/latest/OpenEXRFileLayout.html
std::string_view exrFault(std::string_view head, std::uint64_t file_bytes);

/// As much of a file as the guard wants.
constexpr std::uint64_t kExrHeadBytes = 1 << 20;

}  // namespace rocinante
