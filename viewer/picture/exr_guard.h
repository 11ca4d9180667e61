#pragma once

#include <cstdint>
#include <string_view>

namespace rocinante {

/// Checks an OpenEXR file before the library reads it. Returns the end of a sentence; empty for no
/// fault, or another format. Finds attributes longer than the file, for which the library would
/// allocate up to 2 GiB, and channels of an unknown type, which abort OpenImageIO. `head` is the
/// beginning of the file of `file_bytes`; the rest is not checked.
/// https://openexr.com/en/latest/OpenEXRFileLayout.html
std::string_view exrFault(std::string_view head, std::uint64_t file_bytes);

/// Bytes of a file that the guard needs.
constexpr std::uint64_t kExrHeadBytes = 1 << 20;

}  // namespace rocinante
