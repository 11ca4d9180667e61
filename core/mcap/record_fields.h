#pragma once

#include <concepts>
#include <type_traits>

#include "core/mcap/records.h"

namespace rocinante::mcap {

template <class T, class Record>
concept IsA = std::same_as<std::remove_const_t<T>, Record>;

// The fields of each record in the order of the file, for writing and for reading: `use` is called
// with all of them. Message and MessageIndex are not here: they are frequent, and done by hand.

void useFields(IsA<Header> auto& r, auto&& use) { use(r.profile, r.library); }
void useFields(IsA<Footer> auto& r, auto&& use) {
  use(r.summary_start, r.summary_offset_start, r.summary_crc);
}
void useFields(IsA<Schema> auto& r, auto&& use) { use(r.id, r.name, r.encoding, r.data); }
void useFields(IsA<Channel> auto& r, auto&& use) {
  use(r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
}
void useFields(IsA<Chunk> auto& r, auto&& use) {
  use(r.message_start_time, r.message_end_time, r.uncompressed_size, r.uncompressed_crc,
      r.compression, r.records);
}
void useFields(IsA<ChunkIndex> auto& r, auto&& use) {
  use(r.message_start_time, r.message_end_time, r.chunk_start_offset, r.chunk_length,
      r.message_index_offsets, r.message_index_length, r.compression, r.compressed_size,
      r.uncompressed_size);
}
/// Without the checksum, which follows.
void useFields(IsA<Attachment> auto& r, auto&& use) {
  use(r.log_time, r.create_time, r.name, r.media_type, r.data);
}
void useFields(IsA<AttachmentIndex> auto& r, auto&& use) {
  use(r.offset, r.length, r.log_time, r.create_time, r.data_size, r.name, r.media_type);
}
void useFields(IsA<Statistics> auto& r, auto&& use) {
  use(r.message_count, r.schema_count, r.channel_count, r.attachment_count, r.metadata_count,
      r.chunk_count, r.message_start_time, r.message_end_time, r.channel_message_counts);
}
void useFields(IsA<Metadata> auto& r, auto&& use) { use(r.name, r.metadata); }
void useFields(IsA<MetadataIndex> auto& r, auto&& use) { use(r.offset, r.length, r.name); }
void useFields(IsA<SummaryOffset> auto& r, auto&& use) {
  use(r.group_opcode, r.group_start, r.group_length);
}
void useFields(IsA<DataEnd> auto& r, auto&& use) { use(r.data_section_crc); }

}  // namespace rocinante::mcap
