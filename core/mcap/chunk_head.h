#pragma once

#include <cstdint>
#include <optional>

#include "core/mcap/records.h"

namespace rocinante {

/// A Chunk record up to its records, read by itself: of chunks whose lengths do not describe them,
/// because the chunk was still open when its recorder was killed (docs/log-format.md), its header
/// was just being completed, the file was cut, or a length is damaged.
struct ChunkHead {
  std::uint64_t offset = 0;         ///< of the opcode
  std::uint64_t length = 0;         ///< of the record's content, as stored
  std::uint64_t records_bytes = 0;  ///< as stored
  std::uint64_t records_start = 0;  ///< file offset
  mcap::Chunk chunk;                ///< its records are all that follows in the file

  /// What `length` says of the length of the records; 0 when it cannot be.
  std::uint64_t recordsByLength() const;
  /// True when the highest byte of the length of the records, or any whole field, is still as it
  /// was when the chunk was begun: then its completion is yet to come or was torn, and none of the
  /// other fields proves anything.
  bool open() const;
  /// True when all those fields are.
  bool wholeOpen() const;
};

/// Empty when no chunk begins there, or the file ends inside its head.
std::optional<ChunkHead> chunkHeadAt(ByteView file, std::uint64_t offset);

/// How many of the bytes, which are the records of an open chunk and whatever follows it, are the
/// chunk's: up to the end of the zstd frame, or up to the first byte that begins no Schema, Channel
/// or Message record, or else, where the file ends first, all.
std::uint64_t openRecordsBytes(ByteView bytes, std::string_view compression);

/// True when the bytes are exactly one zstd frame, or whole Schema, Channel and Message records.
bool wholeRecords(ByteView bytes, std::string_view compression);

}  // namespace rocinante
