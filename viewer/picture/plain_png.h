#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bytes.h"

namespace rocinante {

/// Decodes the PNG that programs write for pictures of a screen, three times as fast as libspng: 8
/// bits, RGB (`components` 3) or RGBA (4), not interlaced, nothing in it but IHDR, IDAT and IEND,
/// every checksum right. `rgba` has width * height * 4 bytes.
///
/// False for anything else, sound or not, with `rgba` in any state: libspng then reads it, or says
/// what is wrong. Never true where libspng would refuse or see other pixels. PNG specification
/// (ISO/IEC 15948), sections 5 and 9.
bool decodePlainPng(ByteView bytes, std::uint32_t width, std::uint32_t height, int components,
                    std::vector<std::uint8_t>& rgba);

}  // namespace rocinante
