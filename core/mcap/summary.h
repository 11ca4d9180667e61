#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/mcap/records.h"
#include "core/mcap/writer_options.h"

namespace rocinante::mcap {

/// The future summary of a file, gathered record by record, so that its size is known at any moment
/// and writing it is simple.
class Summary {
 public:
  explicit Summary(const WriterOptions& options) : options_(options) {}

  /// `record`: as written in the data section.
  void addSchema(ByteView record);
  /// Adds a channel without messages so far.
  void addChannel(std::uint16_t id, ByteView record);
  void addMessages(std::uint16_t channel_id, std::uint64_t count);
  /// Adds `count` messages in this span of time.
  void addTimes(std::uint64_t start, std::uint64_t end, std::uint64_t count);
  void addChunk(const ChunkIndex& index);
  void addAttachment(const AttachmentIndex& index);
  void addMetadata(const MetadataIndex& index);

  /// From now on leaves out channels without messages: the disk is full, and they were added when
  /// the room for them was already gone.
  void leaveOutUnused() { leaves_out_unused_ = true; }

  /// An upper bound of the size of build(), with one more chunk that has messages of these
  /// channels.
  std::uint64_t bytes(std::span<const std::uint16_t> chunk_channels) const;
  static std::uint64_t bytesFor(const AttachmentIndex& index);
  static std::uint64_t bytesFor(const MetadataIndex& index);

  /// Summary, offsets, Footer and closing magic, to be written at `summary_start`.
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
  Statistics statistics_;  ///< without the parts in channels_
  Bytes schemas_;
  std::vector<std::uint16_t> channel_order_;  ///< in the order added
  std::map<std::uint16_t, ChannelEntry> channels_;
  std::uint64_t channel_bytes_ = 0;
  Bytes chunk_indexes_;
  Bytes attachment_indexes_;
  Bytes metadata_indexes_;
  bool leaves_out_unused_ = false;
};

}  // namespace rocinante::mcap
