#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/mcap/chunk_compressor.h"
#include "core/mcap/growing_file.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// The chunk that currently takes messages. It stays in memory until it is closed or flushed; once
/// flushed, it is begun in the file and grows there with open lengths (docs/log-format.md, "The
/// open chunk"). One object makes one chunk after another.
class OpenChunk {
 public:
  /// One channel's part of the chunk. Kept with the channel, so that a message needs no lookup.
  struct Part {
    MessageIndex index;
    bool declared = false;
  };

  OpenChunk(std::optional<int> zstd_level, std::size_t chunk_bytes, bool message_indexes);

  bool empty() const { return !begun() && !unflushed(); }
  /// The chunk is begun in the file, and nothing else can be appended there until it is closed.
  bool begun() const { return stage_ != Stage::in_memory; }
  bool unflushed() const { return buffer_.size() > kHeaderRoom; }
  std::uint64_t bytes() const { return kept_bytes_ + pending().size(); }  ///< uncompressed

  /// The buffer for the records that declare what a message needs, before the message.
  Bytes& records() { return buffer_; }
  /// `part` must not move until startNext().
  void add(Part& part, const Message& message);
  /// In the order of their first message.
  const std::vector<Part*>& parts() const { return parts_; }

  /// The bytes that closing the chunk appends to the file in addition to its records.
  std::uint64_t closingBytes() const;

  /// Begins the chunk in the file, or appends the records that are not there yet. When it fails,
  /// these stay unflushed and can only be dropped. `tail_bytes` must still fit behind the closed
  /// chunk.
  Status flush(GrowingFile& file, std::uint64_t tail_bytes);
  /// Closes the chunk: writes all of it at once, or the part that is missing. After a failure, once
  /// the unflushed records are dropped, it can be called again and continues where it stopped.
  Status close(GrowingFile& file, std::uint64_t tail_bytes);
  /// The chunk is complete in the file; perhaps without its message indexes, when they did not fit.
  bool closed() const { return stage_ == Stage::closed; }
  /// The index of a chunk that is closed().
  const ChunkIndex& index() const { return index_; }

  /// Forgets the records that are not in the file: returns the number of messages by channel.
  std::vector<std::pair<std::uint16_t, std::uint64_t>> dropUnflushed();

  void startNext();

 private:
  /// Room before the records: the longest header of a Chunk record.
  static constexpr std::size_t kHeaderRoom = 53;
  enum class Stage { in_memory, open, ended, patched, closed };

  ByteView pending() const { return ByteView(buffer_).subspan(kHeaderRoom); }
  bool compressed() const { return index_.compression == "zstd"; }
  Status closeInOnePiece(GrowingFile& file, std::uint64_t tail_bytes);
  Status endData(GrowingFile& file, std::uint64_t tail_bytes);
  Status patchHeader(GrowingFile& file);
  Status appendIndexes(GrowingFile& file, std::uint64_t tail_bytes);
  Status appendPiece(GrowingFile& file, ByteView piece, std::size_t header_bytes,
                     std::uint64_t tail_bytes);
  std::uint64_t indexBytes() const;
  void putIndexes(Bytes& out, std::uint64_t file_offset);

  std::optional<int> zstd_level_;
  std::size_t chunk_bytes_;
  bool message_indexes_;
  std::optional<ChunkCompressor> compressor_;
  FrameStream stream_;

  Stage stage_ = Stage::in_memory;
  Bytes buffer_;  ///< kHeaderRoom, then the records that are not in the file yet
  Bytes out_;     ///< the bytes being written
  std::vector<Part*> parts_;

  ChunkIndex index_;              ///< as far as known
  std::uint64_t kept_bytes_ = 0;  ///< of the records in the file, uncompressed
  std::uint32_t kept_crc_ = 0;    ///< of these
  std::uint32_t stored_crc_ = 0;  ///< of these as stored
};

}  // namespace rocinante::mcap
