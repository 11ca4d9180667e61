#pragma once

#include <optional>
#include <string_view>

#include "core/base/bytes.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// A track as bytes, for a cache: of this processor's byte order, with a checksum of all of it.
Bytes encodeTrack(const SessionTrack& track, std::string_view key);
/// Empty when the bytes are not whole, of another version, or of another key.
std::optional<SessionTrack> decodeTrack(ByteView bytes, std::string_view key);

}  // namespace rocinante
