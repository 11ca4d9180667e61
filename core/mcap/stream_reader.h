#pragma once

#include <cstdint>
#include <optional>

#include "core/base/result.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// A record as stored. Borrowed.
struct Record {
  Opcode opcode = Opcode::invalid;
  std::uint64_t offset = 0;  ///< of the opcode
  ByteView content;

  std::uint64_t end() const { return offset + kPrefixBytes + content.size(); }
};

/// The record at `offset` of `bytes`; empty when its prefix or its content would extend past the
/// end.
std::optional<Record> recordAt(ByteView bytes, std::uint64_t offset);

/// Reads an MCAP file strictly from its first record to its footer: the first breach of the format
/// is an error. (LogReader continues after damage.) Chunks are expanded, their CRC is checked, and
/// their records are returned instead of them.
class StreamReader {
 public:
  /// damaged when the file does not start with the magic. `file` must outlive the reader.
  static Result<StreamReader> open(ByteView file);

  /// The next record, valid until the next call; its offset is in the file, or in the expanded
  /// chunk. Empty after the footer, which the closing magic must follow.
  Result<std::optional<Record>> next();

 private:
  explicit StreamReader(ByteView file) : file_(file) {}
  Result<std::optional<Record>> nextInChunk();

  ByteView file_;
  std::uint64_t position_ = 8;
  bool ended_ = false;
  ChunkExpander expander_;
  Scratch scratch_;
  ByteView chunk_;
  std::uint64_t chunk_position_ = 0;
  std::uint64_t chunk_offset_ = 0;  ///< of the chunk in the file, for errors
};

}  // namespace rocinante::mcap
