#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/log/byte_sink.h"
#include "core/log/chunk_compressor.h"
#include "core/log/mcap_records.h"
#include "core/result.h"

namespace rocinante::mcap {

struct WriterOptions {
  bool chunked = true;
  std::optional<int> zstd_level = 1;    ///< empty: chunks are not compressed
  std::size_t chunk_bytes = 1U << 20U;  ///< uncompressed; a chunk that holds this is closed
  bool message_indexes = true;
  bool chunk_indexes = true;
  bool attachment_indexes = true;
  bool metadata_indexes = true;
  bool statistics = true;
  bool repeat_schemas = true;   ///< in the summary
  bool repeat_channels = true;  ///< in the summary
  bool summary_offsets = true;
};

/// Writes any MCAP file; LogWriter is the profile on top of it. Schemas and channels are declared
/// once and written where they are first used, in every chunk anew, so that each chunk can be read
/// alone. A record stands in the file whole or not at all: after a failed write the file is cut
/// back to the last whole record, and finish() can still be tried. Starts no threads.
class Writer {
 public:
  /// Writes the magic and the header.
  static Result<Writer> start(std::unique_ptr<ByteSink> sink, const WriterOptions& options,
                              const Header& header);

  /// Ids must be new.
  void addSchema(Schema schema);
  void addChannel(Channel channel);

  /// The channel must have been added. Fails when this message, or the chunk that it filled, could
  /// not be written: then no message of that chunk stands in the file (see lost()).
  Status write(const Message& message);
  Status writeAttachment(const Attachment& attachment);
  Status writeMetadata(const Metadata& metadata);

  /// Writes the open chunk, if it holds anything.
  Status closeChunk();
  bool chunkOpen() const { return !chunk_.empty(); }

  /// Closes the chunk, writes the summary, closes the file. When the disk refuses, it leaves what
  /// is whole. Nothing may be called after it.
  Status finish();

  /// Bytes that stand in the file, the open chunk not among them.
  std::uint64_t bytesWritten() const { return position_; }
  /// Per channel id: messages given to write() that the disk refused.
  const std::map<std::uint16_t, std::uint64_t>& lost() const { return lost_; }

 private:
  struct ChannelState {
    Channel channel;
    std::uint64_t messages = 0;
    bool declared = false;  ///< in the open chunk, or in the file when it has none
    MessageIndex index;     ///< of the open chunk
  };
  struct SchemaState {
    Schema schema;
    bool declared = false;
  };

  Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options);

  /// Appends whole records to the file, or leaves it as it was.
  Status put(ByteView bytes);
  void declare(ChannelState& channel, Bytes& out);
  void countMessage(std::uint64_t log_time);
  void startChunk();
  Bytes summary(std::uint64_t summary_start) const;

  std::unique_ptr<ByteSink> sink_;
  WriterOptions options_;
  std::uint64_t position_ = 0;
  std::uint32_t data_crc_ = 0;
  std::optional<ChunkCompressor> compressor_;

  std::vector<std::unique_ptr<ChannelState>> channels_;  ///< in order of adding
  std::vector<ChannelState*> channel_by_id_;
  std::vector<SchemaState> schemas_;

  Bytes chunk_;
  std::uint64_t chunk_start_time_ = 0;
  std::uint64_t chunk_end_time_ = 0;
  std::vector<ChannelState*> chunk_channels_;  ///< in order of their first message
  Bytes scratch_;

  Statistics statistics_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  std::map<std::uint16_t, std::uint64_t> lost_;
};

}  // namespace rocinante::mcap
