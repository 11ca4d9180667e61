#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/mcap/records.h"
#include "core/mcap/writer_options.h"

namespace rocinante::mcap {

/// What a file's summary will say: gathered record by record, so that its size is known at any
/// moment and writing it takes no thought.
class Summary {
 public:
  explicit Summary(const WriterOptions& options) : options_(options) {}

  /// `record` as it stands in the data section.
  void addSchema(ByteView record);
  /// Without a message so far.
  void addChannel(std::uint16_t id, ByteView record);
  void addMessages(std::uint16_t channel_id, std::uint64_t count);
  /// Messages in this span of time, `count` in all.
  void addTimes(std::uint64_t start, std::uint64_t end, std::uint64_t count);
  void addChunk(const ChunkIndex& index);
  void addAttachment(const AttachmentIndex& index);
  void addMetadata(const MetadataIndex& index);

  /// Leaves out channels that have no message, from now on: the disk is full, and they were added
  /// when the room for them was no longer there.
  void leaveOutUnused() { leaves_out_unused_ = true; }

  /// Of build(), at most, with one more chunk that has messages of these channels.
  std::uint64_t bytes(std::span<const std::uint16_t> chunk_channels) const;
  static std::uint64_t bytesFor(const AttachmentIndex& index);
  static std::uint64_t bytesFor(const MetadataIndex& index);

  /// Summary, offsets, Footer and closing magic, as they stand from `summary_start` on.
  Bytes build(std::uint64_t summary_start) const;

 private:
  struct ChannelEntry {
    Bytes record;
    std::uint64_t messages = 0;
  };
  bool leftOut(const ChannelEntry& channel) const {
    return leaves_out_unused_ && channel.messages == 0;
  }
  void appendStatistics(Bytes& out) const;

  WriterOptions options_;
  Statistics statistics_;  ///< without what channels_ tells
  Bytes schemas_;
  std::vector<std::uint16_t> channel_order_;  ///< as they were added
  std::map<std::uint16_t, ChannelEntry> channels_;
  std::uint64_t channel_bytes_ = 0;
  Bytes chunk_indexes_;
  Bytes attachment_indexes_;
  Bytes metadata_indexes_;
  bool leaves_out_unused_ = false;
};

}  // namespace rocinante::mcap
