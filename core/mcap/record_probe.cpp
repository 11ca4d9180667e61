#include "core/mcap/record_probe.h"

#include "core/mcap/byte_cursor.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Larger schemas, channels and the like are not searched for after damage.
constexpr std::size_t kMaxPlausibleBytes = 1U << 16U;

/// The chunk was cut off by the end of the file, or was still open.
bool beginsTornChunk(ByteView file, std::uint64_t offset) {
  const std::optional<ChunkHead> head = chunkHeadAt(file, offset);
  if (!head || !knownCompression(head->chunk.compression)) return false;
  if (head->wholeOpen()) return true;
  return head->recordsByLength() == head->records_bytes &&
         head->chunk.message_start_time <= head->chunk.message_end_time &&
         head->chunk.uncompressed_size <= mcap::kMaxChunkBytes;
}

}  // namespace

bool knownCompression(std::string_view name) {
  return name.empty() || name == "zstd" || name == "lz4";
}

std::string_view compressionName(std::string_view name) {
  return name == "zstd" ? "zstd" : name == "lz4" ? "lz4" : name.empty() ? "" : name;
}

bool RecordProbe::plausibleAt(std::uint64_t offset) {
  if (offset == file_.size()) return true;
  const std::optional<mcap::Record> record = mcap::recordAt(file_, offset);
  if (!record) return beginsTornChunk(file_, offset);
  if (!plausible(*record)) return false;
  if (record->end() == file_.size()) return true;
  const std::optional<mcap::Record> next = mcap::recordAt(file_, record->end());
  if (next) return plausible(*next);
  // No whole record follows: the file may have been cut there.
  return file_.size() - record->end() < mcap::kPrefixBytes || record->opcode == Opcode::footer ||
         record->opcode == Opcode::message_index || record->opcode == Opcode::chunk ||
         beginsTornChunk(file_, record->end());
}

bool RecordProbe::plausible(const mcap::Record& record) {
  const ByteView content = record.content;
  switch (record.opcode) {
    case Opcode::chunk: {
      mcap::Chunk chunk;
      return mcap::parse(content, chunk) && knownCompression(chunk.compression) &&
             chunk.message_start_time <= chunk.message_end_time;
    }
    case Opcode::message_index: {
      const std::optional<mcap::IndexEntries> index = mcap::indexEntries(content);
      return index && content.size() == mcap::IndexEntries::kHeadBytes + index->entries.size();
    }
    case Opcode::message:
      return content.size() >= mcap::kMessageHeaderBytes;
    case Opcode::data_end:
      return content.size() == mcap::kDataEndContentBytes;
    case Opcode::footer:
      return content.size() == mcap::kFooterContentBytes;
    case Opcode::channel:
      return parses<mcap::Channel>(content);
    case Opcode::schema:
      return parses<mcap::Schema>(content);
    case Opcode::attachment:
      return parses<mcap::Attachment>(content);
    case Opcode::metadata:
      return parses<mcap::Metadata>(content);
    case Opcode::statistics:
      return parses<mcap::Statistics>(content);
    case Opcode::chunk_index:
      return parses<mcap::ChunkIndex>(content);
    case Opcode::attachment_index:
      return parses<mcap::AttachmentIndex>(content);
    case Opcode::metadata_index:
      return parses<mcap::MetadataIndex>(content);
    case Opcode::summary_offset:
      return parses<mcap::SummaryOffset>(content);
    case Opcode::invalid:
    case Opcode::header:
      return false;
  }
  return false;
}

template <class T>
bool RecordProbe::parses(ByteView content) {
  if (content.size() > kMaxPlausibleBytes || content.size() > budget_bytes_) return false;
  budget_bytes_ -= content.size();
  T ignored;
  return mcap::parse(content, ignored).has_value();
}

std::uint64_t RecordProbe::resumeBehind(std::uint64_t offset) {
  do {
    ++offset;
  } while (offset < file_.size() && !resumesAt(offset));
  return offset;
}

bool RecordProbe::resumesAt(std::uint64_t offset) {
  const auto opcode = static_cast<Opcode>(file_[static_cast<std::size_t>(offset)]);
  switch (opcode) {
    case Opcode::schema:
    case Opcode::channel:
    case Opcode::message:
    case Opcode::chunk:
    case Opcode::attachment:
    case Opcode::metadata:
    case Opcode::data_end:
      return plausibleAt(offset);
    default:
      return false;
  }
}

}  // namespace rocinante
