#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/foreign/decode/declaration.h"

namespace rocinante::decode {

/// Bytes of the sum as it is sent.
std::size_t checksumBytes(ChecksumKind kind);
/// Of `bytes` and then `after`.
std::uint32_t checksumOf(ChecksumKind kind, ByteView bytes, ByteView after);

/// A position that may count from the end; empty when it is not in the datagram.
std::optional<std::size_t> positionIn(std::int64_t position, std::size_t datagram_bytes);

/// True when the sum in the datagram is that of its bytes.
bool checksumHolds(const Checksum& checksum, ByteView datagram);

}  // namespace rocinante::decode
