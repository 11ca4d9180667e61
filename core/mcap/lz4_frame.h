#pragma once

#include <cstddef>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante::mcap {

/// Whether this build expands LZ4 (liblz4).
bool canExpandLz4();

/// Expands LZ4 frames into at most `room` bytes at `out`, and returns how many it became. damaged
/// when they are not whole frames, fail a checksum, or need more room; unsupported without liblz4.
Result<std::size_t> expandLz4(ByteView frames, std::byte* out, std::size_t room);

/// How many bytes the frames give before they stop being valid or `room` is full: for what a killed
/// writer left. 0 without liblz4.
std::size_t expandCutLz4(ByteView frames, std::byte* out, std::size_t room);

}  // namespace rocinante::mcap
