#include "core/mcap/chunk_head.h"

#include "core/mcap/byte_cursor.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {
namespace {

using mcap::kOpenEnded;
using mcap::Opcode;

bool belongsInChunk(Opcode opcode) {
  return opcode == Opcode::schema || opcode == Opcode::channel || opcode == Opcode::message;
}

/// The total length of the whole Schema, Channel and Message records at the front.
std::uint64_t recordRunBytes(ByteView bytes) {
  mcap::RecordStepper steps(bytes);
  while (const std::optional<mcap::Record> record = steps.peek()) {
    if (!belongsInChunk(record->opcode)) break;
    steps.moveTo(record->end());
  }
  return steps.position();
}

}  // namespace

std::uint64_t ChunkHead::recordsByLength() const {
  const std::uint64_t head_bytes = records_start - offset - mcap::kPrefixBytes;
  return length >= head_bytes ? length - head_bytes : 0;
}

bool ChunkHead::open() const {
  return records_bytes >> 56U == 0xFF || length == kOpenEnded ||
         chunk.message_end_time == kOpenEnded || chunk.uncompressed_size == kOpenEnded;
}

bool ChunkHead::wholeOpen() const {
  return length == kOpenEnded && chunk.message_end_time == kOpenEnded &&
         chunk.uncompressed_size == kOpenEnded && records_bytes == kOpenEnded &&
         chunk.uncompressed_crc == 0;
}

std::optional<ChunkHead> chunkHeadAt(ByteView file, std::uint64_t offset) {
  if (offset >= file.size()) return std::nullopt;
  mcap::ByteCursor cursor(file.subspan(static_cast<std::size_t>(offset)));
  ChunkHead head;
  head.offset = offset;
  if (static_cast<Opcode>(cursor.number<std::uint8_t>()) != Opcode::chunk) return std::nullopt;
  head.length = cursor.number<std::uint64_t>();
  head.chunk.message_start_time = cursor.number<std::uint64_t>();
  head.chunk.message_end_time = cursor.number<std::uint64_t>();
  head.chunk.uncompressed_size = cursor.number<std::uint64_t>();
  head.chunk.uncompressed_crc = cursor.number<std::uint32_t>();
  head.chunk.compression = cursor.string();
  head.records_bytes = cursor.number<std::uint64_t>();
  head.records_start = offset + cursor.position();
  head.chunk.records = cursor.take(cursor.remaining());
  if (!cursor.ok()) return std::nullopt;
  return head;
}

std::uint64_t openRecordsBytes(ByteView bytes, std::string_view compression) {
  if (!compression.empty()) return mcap::zstdFrameBytes(bytes).value_or(bytes.size());
  const std::uint64_t run = recordRunBytes(bytes);
  if (run == bytes.size()) return run;
  // The last addition may have been cut off: its bytes still belong to the chunk.
  const bool cut = belongsInChunk(static_cast<Opcode>(bytes[static_cast<std::size_t>(run)])) &&
                   !mcap::recordAt(bytes, run);
  return cut ? bytes.size() : run;
}

bool wholeRecords(ByteView bytes, std::string_view compression) {
  return compression.empty() ? recordRunBytes(bytes) == bytes.size()
                             : mcap::zstdFrameBytes(bytes) == bytes.size();
}

}  // namespace rocinante
