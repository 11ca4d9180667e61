#pragma once

#include <cstddef>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// A judged frame as bytes, for another process of the same build; not a file format. The frame,
/// which the receiver has from its own suite, and why it differs are left out.
Bytes wireBytes(const JudgedFrame& judged);
/// Fills in what wireBytes() wrote. damaged when the bytes are invalid; `judged` is then
/// unspecified.
Status readWire(ByteView bytes, JudgedFrame& judged);

}  // namespace rocinante
