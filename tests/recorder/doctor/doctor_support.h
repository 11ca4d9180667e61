#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/mcap/append_record.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/records.h"
#include "recorder/doctor/log_doctor.h"

namespace rocinante {

inline void PrintTo(const Finding& breach, std::ostream* out) {
  *out << breach.rule << " at " << breach.byte.value_or(0) << ": " << breach.text;
}

}  // namespace rocinante

namespace rocinante::test {

/// A file of the profile, assembled by hand, so that a test can break one rule and leave everything
/// else correct: checksums, offsets and counts match the contents unless a test overrides them.
class HandMade {
 public:
  struct Message {
    std::uint16_t channel = 1;
    std::uint64_t time = 0;
    std::string payload;
  };
  struct Chunk {
    std::vector<mcap::Channel> channels;
    std::vector<Message> messages;
    Bytes extra;  ///< records after the messages
    std::function<void(mcap::Chunk&)> change;
    std::function<void(std::vector<mcap::MessageIndex>&)> change_indexes;
    std::function<void(mcap::ChunkIndex&)> change_chunk_index;
    bool indexed = true;  ///< in the summary
  };

  std::string profile = "rocinante";
  std::vector<mcap::Metadata> metadata_before;  ///< the chunks
  std::vector<Chunk> chunks;
  std::vector<mcap::Attachment> attachments;
  std::vector<mcap::Metadata> metadata_behind;
  std::vector<mcap::Channel> summary_channels;
  Bytes loose;  ///< records between chunks and attachments
  std::function<void(mcap::Statistics&)> change_statistics;
  std::function<void(std::vector<mcap::AttachmentIndex>&)> change_attachment_indexes;
  std::function<void(std::vector<mcap::MetadataIndex>&)> change_metadata_indexes;
  std::function<void(std::vector<mcap::SummaryOffset>&)> change_offsets;
  std::function<void(mcap::Footer&)> change_footer;  ///< before its checksum is made
  std::uint32_t summary_crc_xor = 0;
  std::function<void(mcap::DataEnd&)> change_data_end;
  std::function<void(Bytes&)> change_summary;  ///< its records, before they are counted
  bool with_statistics = true;
  bool statistics_first = false;

  /// A file that keeps every rule: two channels, two chunks, an attachment.
  static HandMade sound() {
    HandMade log;
    const mcap::Channel arm{1, 0, "/udp/1/arm", "rk1", {{"source", "arm"}}};
    const mcap::Channel raw{2, 0, "/udp/1/raw", "octets", {}};
    log.metadata_before = {{std::string(profile::kSession),
                            {{"format", "1"}, {"session_id", "s"}, {"origin_ns", "1000"}}}};
    Chunk first;
    first.channels = {arm, raw};
    first.messages = {{1, 1000, "RK1 arm 0 -\njoints arm 1"},
                      {2, 1001, "raw"},
                      {1, 1002, "RK1 arm 1 -\njoints arm 2"}};
    Chunk second;
    second.channels = {arm};
    second.messages = {{1, 1002, "RK1 arm 2 -"}, {1, 1005, "RK1 arm 3 -\njoints arm 4"}};
    log.chunks = {first, second};
    static const std::string kData = "the cell";
    mcap::Attachment cell;
    cell.log_time = 1000;
    cell.name = "cell.toml";
    cell.media_type = "application/toml";
    cell.data = bytesOf(kData);
    log.attachments = {cell};
    log.metadata_behind = {{std::string(profile::kEnd),
                            {{"reason", "stopped"}, {"session_id", "s"}, {"origin_ns", "1000"}}}};
    log.summary_channels = {arm, raw};
    return log;
  }

  Bytes bytes() const {
    Bytes file(mcap::magic().begin(), mcap::magic().end());
    mcap::append(file, mcap::Header{profile, "by hand"});
    std::vector<mcap::MetadataIndex> metadata_indexes;
    std::vector<mcap::AttachmentIndex> attachment_indexes;
    std::vector<mcap::ChunkIndex> chunk_indexes;
    mcap::Statistics statistics;
    const auto addMetadata = [&](const mcap::Metadata& metadata) {
      const std::size_t offset = file.size();
      mcap::append(file, metadata);
      metadata_indexes.push_back({offset, file.size() - offset, metadata.name});
      ++statistics.metadata_count;
    };
    for (const mcap::Metadata& each : metadata_before) addMetadata(each);
    for (const Chunk& each : chunks) addChunk(each, file, chunk_indexes, statistics);
    file.insert(file.end(), loose.begin(), loose.end());
    for (const mcap::Attachment& each : attachments) {
      const std::size_t offset = file.size();
      mcap::append(file, each);
      attachment_indexes.push_back({offset, file.size() - offset, each.log_time, each.create_time,
                                    each.data.size(), each.name, each.media_type});
      ++statistics.attachment_count;
    }
    for (const mcap::Metadata& each : metadata_behind) addMetadata(each);
    mcap::DataEnd data_end{crc32(file)};
    if (change_data_end) change_data_end(data_end);
    mcap::append(file, data_end);

    statistics.channel_count = static_cast<std::uint32_t>(summary_channels.size());
    if (change_statistics) change_statistics(statistics);
    if (change_attachment_indexes) change_attachment_indexes(attachment_indexes);
    if (change_metadata_indexes) change_metadata_indexes(metadata_indexes);
    Bytes summary;
    if (with_statistics && statistics_first) mcap::append(summary, statistics);
    for (const mcap::Channel& each : summary_channels) mcap::append(summary, each);
    if (with_statistics && !statistics_first) mcap::append(summary, statistics);
    for (const mcap::ChunkIndex& each : chunk_indexes) mcap::append(summary, each);
    for (const mcap::AttachmentIndex& each : attachment_indexes) mcap::append(summary, each);
    for (const mcap::MetadataIndex& each : metadata_indexes) mcap::append(summary, each);
    if (change_summary) change_summary(summary);

    const std::size_t summary_start = file.size();
    std::vector<mcap::SummaryOffset> offsets;
    for (std::uint64_t at = 0; at < summary.size();) {
      const auto record = mcap::recordAt(summary, at);
      if (!record) break;
      if (offsets.empty() || offsets.back().group_opcode != record->opcode) {
        offsets.push_back({record->opcode, summary_start + at, 0});
      }
      offsets.back().group_length += record->end() - at;
      at = record->end();
    }
    if (change_offsets) change_offsets(offsets);
    file.insert(file.end(), summary.begin(), summary.end());
    mcap::Footer footer{summary.empty() ? 0 : summary_start, offsets.empty() ? 0 : file.size(), 0};
    for (const mcap::SummaryOffset& each : offsets) mcap::append(file, each);
    Bytes with_footer(file.begin() + static_cast<std::ptrdiff_t>(summary_start), file.end());
    if (change_footer) change_footer(footer);
    mcap::append(with_footer, footer);
    footer.summary_crc =
        summary_crc_xor ^ crc32(ByteView(with_footer).first(with_footer.size() - 4));
    mcap::append(file, footer);
    file.insert(file.end(), mcap::magic().begin(), mcap::magic().end());
    return file;
  }

 private:
  static void addChunk(const Chunk& chunk, Bytes& file, std::vector<mcap::ChunkIndex>& indexes,
                       mcap::Statistics& statistics) {
    Bytes records;
    for (const mcap::Channel& channel : chunk.channels) mcap::append(records, channel);
    std::map<std::uint16_t, mcap::MessageIndex> by_channel;
    mcap::Chunk record;
    for (const Message& message : chunk.messages) {
      mcap::MessageIndex& index = by_channel[message.channel];
      index.channel_id = message.channel;
      index.records.emplace_back(message.time, records.size());
      const auto sequence = static_cast<std::uint32_t>(index.records.size());
      mcap::append(records, mcap::Message{message.channel, sequence, message.time, message.time,
                                          bytesOf(message.payload)});
      const bool first = &message == &chunk.messages.front();
      record.message_start_time =
          first ? message.time : std::min(record.message_start_time, message.time);
      record.message_end_time = std::max(record.message_end_time, message.time);
      const bool first_of_all = statistics.message_count++ == 0;
      statistics.message_start_time =
          first_of_all ? message.time : std::min(statistics.message_start_time, message.time);
      statistics.message_end_time = std::max(statistics.message_end_time, message.time);
      ++statistics.channel_message_counts[message.channel];
    }
    ++statistics.chunk_count;
    records.insert(records.end(), chunk.extra.begin(), chunk.extra.end());
    record.uncompressed_size = records.size();
    record.uncompressed_crc = crc32(records);
    record.records = records;
    if (chunk.change) chunk.change(record);
    mcap::ChunkIndex chunk_index;
    chunk_index.chunk_start_offset = file.size();
    mcap::append(file, record);
    chunk_index.message_start_time = record.message_start_time;
    chunk_index.message_end_time = record.message_end_time;
    chunk_index.chunk_length = file.size() - chunk_index.chunk_start_offset;
    chunk_index.compression = record.compression;
    chunk_index.compressed_size = record.records.size();
    chunk_index.uncompressed_size = record.uncompressed_size;
    std::vector<mcap::MessageIndex> message_indexes;
    for (const auto& [channel, index] : by_channel) message_indexes.push_back(index);
    if (chunk.change_indexes) chunk.change_indexes(message_indexes);
    const std::size_t start = file.size();
    for (const mcap::MessageIndex& index : message_indexes) {
      chunk_index.message_index_offsets.emplace(index.channel_id, file.size());
      mcap::append(file, index);
    }
    chunk_index.message_index_length = file.size() - start;
    if (chunk.change_chunk_index) chunk.change_chunk_index(chunk_index);
    if (chunk.indexed) indexes.push_back(chunk_index);
  }
};

/// Updates the checksum after a test has changed bytes of the data section.
inline Bytes resealed(Bytes file) {
  std::uint64_t at = mcap::magic().size();
  while (const auto record = mcap::recordAt(file, at)) {
    if (record->opcode == mcap::Opcode::data_end) {
      const std::uint32_t crc = crc32(ByteView(file).first(static_cast<std::size_t>(at)));
      std::memcpy(file.data() + at + mcap::kPrefixBytes, &crc, sizeof crc);
      break;
    }
    at = record->end();
  }
  return file;
}

inline DoctorReport examine(const Bytes& file) {
  Result<DoctorReport> report = examineBytes(file, "test.mcap");
  EXPECT_TRUE(report.ok()) << report.error().text();
  return std::move(*report);
}

}  // namespace rocinante::test
