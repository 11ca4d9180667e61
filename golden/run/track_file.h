#pragma once

#include <optional>
#include <string_view>

#include "core/base/bytes.h"
#include "core/log/mapped_file.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// A track as a file of this machine's byte order: its samples, then this: everything else, the
/// key, and a checksum of all.
Bytes encodeTrackTail(const SessionTrack& track, std::string_view key);
/// The track of a file of that key, which it keeps; empty for anything else.
std::optional<SessionTrack> decodeTrack(MappedFile file, std::string_view key);

}  // namespace rocinante
