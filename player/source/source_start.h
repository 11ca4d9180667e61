#pragma once

#include <cstddef>
#include <string>

#include "core/base/time.h"
#include "player/source/source.h"

namespace rocinante {

/// The clock that TIME and signatures are taken from.
WallTime wallNow();

/// RUN, or else ten hexadecimal digits chosen anew at each start, so that a receiver can tell a
/// restart from late packets.
std::string runOf(const SourceOptions& options);

/// The largest datagram before it is signed, bytes.
std::size_t unsignedBytes(const SourceOptions& options);

}  // namespace rocinante
