#pragma once

#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// Checks faults that decoders ignore. Requires bytes that libspng decoded to the end. unsupported
/// for an animation (APNG) and for a second PNG after the first; damaged when anything else follows
/// IEND, when IEND has content, or when the number of compressed pixels differs from the header,
/// their checksum fails or bytes follow them. `name` is used in messages. PNG specification
/// (ISO/IEC 15948), sections 5, 7, 8 and 10; APNG's acTL.
Status checkWholePng(ByteView bytes, const std::string& name);

}  // namespace rocinante
