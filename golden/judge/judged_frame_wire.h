#pragma once

#include <cstddef>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// A judged frame as bytes, from one process of a program to another of the same build: no format
/// for files. What the receiver knows from its own suite (the frame, its limits and expectation) is
/// left out.
Bytes wireBytes(const JudgedFrame& judged);
/// Fills in what wireBytes() wrote. damaged when the bytes are no such frame; `judged` is then
/// of no use.
Status readWire(ByteView bytes, JudgedFrame& judged);

}  // namespace rocinante
