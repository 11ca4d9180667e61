#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"

/// The records of an MCAP file, version 0, field by field in the order of their bytes. The format
/// is the public specification (https://mcap.dev/spec); docs/log-format.md says which part of it a
/// log uses.
namespace rocinante::mcap {

inline constexpr unsigned char kMagicBytes[8] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline ByteView magic() { return std::as_bytes(std::span(kMagicBytes)); }

/// Opcode (u8) and length of the content (u64), before the content of every record.
inline constexpr std::size_t kPrefixBytes = 9;
inline constexpr std::size_t kFooterContentBytes = 20;
inline constexpr std::size_t kDataEndContentBytes = 4;
inline constexpr std::size_t kMessageHeaderBytes = 22;
/// The end of every whole file: the Footer record and the magic.
inline constexpr std::size_t kFileEndBytes = kPrefixBytes + kFooterContentBytes + 8;
/// A length that is not known yet, all eight bytes set: that of the chunk being written.
inline constexpr std::uint64_t kOpenEnded = ~std::uint64_t{0};

enum class Opcode : std::uint8_t {
  invalid = 0x00,
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// "Chunk", "MessageIndex" ...: the specification's names; "record" for an unknown opcode.
std::string_view nameOf(Opcode opcode);

struct Header {
  std::string profile;
  std::string library;
};

struct Footer {
  std::uint64_t summary_start = 0;         ///< file offset; 0 when there is no summary
  std::uint64_t summary_offset_start = 0;  ///< file offset; 0 when there are none
  std::uint32_t summary_crc = 0;  ///< from summary start through summary_offset_start; 0: none
};

struct Schema {
  std::uint16_t id = 0;  ///< never 0: that means "no schema" in a Channel
  std::string name;
  std::string encoding;
  Bytes data;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string topic;
  std::string message_encoding;
  std::map<std::string, std::string> metadata;
  bool operator==(const Channel&) const = default;
};

struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  ByteView data;  ///< borrowed
};

struct Chunk {
  std::uint64_t message_start_time = 0;  ///< both 0 when it holds no message
  std::uint64_t message_end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not computed
  std::string_view compression;        ///< "", "zstd", "lz4"; borrowed
  ByteView records;                    ///< as stored; borrowed
};

struct MessageIndex {
  std::uint16_t channel_id = 0;
  /// (log_time, offset of the Message's opcode in the uncompressed chunk), in order of writing.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> records;
};

struct ChunkIndex {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t chunk_start_offset = 0;
  std::uint64_t chunk_length = 0;  ///< with the prefix
  /// channel -> file offset of its MessageIndex; empty means unknown.
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  ByteView data;          ///< borrowed
  std::uint32_t crc = 0;  ///< as stored; append() computes it. 0: not computed
  ByteView checked;       ///< by parse(): the bytes that crc is of
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with the prefix
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};

struct Metadata {
  std::string name;
  std::map<std::string, std::string> metadata;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with the prefix
  std::string name;
};

struct SummaryOffset {
  Opcode group_opcode = Opcode::invalid;
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
};

struct DataEnd {
  std::uint32_t data_section_crc = 0;  ///< of every byte before this record; 0: not computed
};

/// A MessageIndex whose entries are not copied: (log_time u64, offset u64) each.
struct IndexEntries {
  static constexpr std::size_t kHeadBytes = 6;  ///< before the entries
  static constexpr std::size_t kEntryBytes = 16;

  std::uint16_t channel = 0;
  ByteView entries;  ///< borrowed

  std::size_t size() const { return entries.size() / kEntryBytes; }
  std::uint64_t time(std::size_t entry) const;
  std::uint64_t offset(std::size_t entry) const;
};

}  // namespace rocinante::mcap
