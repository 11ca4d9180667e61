#pragma once

#include <cstdint>
#include <optional>

#include "core/mcap/records.h"

namespace rocinante {

/// The bytes of a Chunk record before its records, without the name of its compression: prefix,
/// times, size, CRC, the name's length, the records' length.
inline constexpr std::uint64_t kChunkHeadBytes = mcap::kPrefixBytes + 8 + 8 + 8 + 4 + 4 + 8;

/// A Chunk record up to its records, read on its own, for chunks whose lengths do not describe
/// them: the chunk was still open when its recorder was killed (docs/log-format.md), its header was
/// being completed, the file was cut, or a length is damaged.
struct ChunkHead {
  std::uint64_t offset = 0;         ///< of the opcode
  std::uint64_t length = 0;         ///< of the record's content, as stored
  std::uint64_t records_bytes = 0;  ///< as stored
  std::uint64_t records_start = 0;  ///< file offset
  mcap::Chunk chunk;                ///< its records are the rest of the file

  /// The records' length implied by `length`; 0 when that is impossible.
  std::uint64_t recordsByLength() const;
  /// True when the highest byte of the records' length, or any whole field, still has the value
  /// from when the chunk was begun: its completion is yet to come or was torn, and the other fields
  /// prove nothing.
  bool open() const;
  /// True when all those fields still have it.
  bool wholeOpen() const;
};

/// Empty when no chunk begins there, or the file ends inside its head.
std::optional<ChunkHead> chunkHeadAt(ByteView file, std::uint64_t offset);

/// How many of the bytes, which are the records of an open chunk and everything after it, belong to
/// the chunk: up to the end of the zstd frame, or up to the first byte that does not begin a
/// Schema, Channel or Message record, or all of them if the file ends first.
std::uint64_t openRecordsBytes(ByteView bytes, std::string_view compression);

/// True when the bytes are exactly one zstd frame, or whole Schema, Channel and Message records.
bool wholeRecords(ByteView bytes, std::string_view compression);

}  // namespace rocinante
