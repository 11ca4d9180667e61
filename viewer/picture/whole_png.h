#pragma once

#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// What decoders pass over in silence and a judge must not: requires bytes that libspng decoded to
/// the end. unsupported for an animation (APNG) and for a PNG behind the first one; damaged when
/// anything follows IEND, when IEND has content, or when the compressed pixels are more or fewer
/// than the header says, fail their checksum or have bytes behind them. `name` is for the sentence.
/// PNG specification (ISO/IEC 15948), sections 5, 7, 8 and 10; APNG's acTL.
Status checkWholePng(ByteView bytes, const std::string& name);

}  // namespace rocinante
