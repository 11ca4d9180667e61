#pragma once

#include <cstdint>
#include <string_view>

namespace rocinante {

/// False for an OpenEXR file with an attribute that is longer than the file: the library would make
/// memory for all of it first, up to 2 GiB. `head` is how the file begins, of `file_bytes` in all;
/// attributes behind the head are not looked at. Anything but OpenEXR is true.
/// https://openexr.com/en/latest/OpenEXRFileLayout.html
bool exrAttributesFit(std::string_view head, std::uint64_t file_bytes);

/// As much of a file as a guard wants.
constexpr std::uint64_t kExrHeadBytes = 1 << 20;

}  // namespace rocinante
