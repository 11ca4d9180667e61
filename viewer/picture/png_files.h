#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "viewer/picture/picture.h"

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

/// A PNG of the same pixels whose data is not compressed (deflate's stored blocks, RFC 1951,
/// section 3.2.4): written and decoded at a large part of memory's speed. RGB when every pixel is
/// opaque. Empty for a picture without pixels, or of 2 GiB.
Bytes storedPng(const Picture& picture);

/// Checks faults that decoders ignore. Requires bytes that libspng decoded to the end. unsupported
/// for an animation (APNG) and for a second PNG after the first; damaged when anything else follows
/// IEND, when IEND has content, or when the number of compressed pixels differs from the header,
/// their checksum fails or bytes follow them. `name` is used in messages. PNG specification
/// (ISO/IEC 15948), sections 5, 7, 8 and 10; APNG's acTL.
Status checkWholePng(ByteView bytes, const std::string& name);

}  // namespace rocinante
