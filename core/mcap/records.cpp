#include "core/mcap/records.h"

#include <cstring>

namespace rocinante::mcap {

std::string_view nameOf(Opcode opcode) {
  switch (opcode) {
    case Opcode::invalid:
      return "record with opcode 0";
    case Opcode::header:
      return "Header";
    case Opcode::footer:
      return "Footer";
    case Opcode::schema:
      return "Schema";
    case Opcode::channel:
      return "Channel";
    case Opcode::message:
      return "Message";
    case Opcode::chunk:
      return "Chunk";
    case Opcode::message_index:
      return "MessageIndex";
    case Opcode::chunk_index:
      return "ChunkIndex";
    case Opcode::attachment:
      return "Attachment";
    case Opcode::attachment_index:
      return "AttachmentIndex";
    case Opcode::statistics:
      return "Statistics";
    case Opcode::metadata:
      return "Metadata";
    case Opcode::metadata_index:
      return "MetadataIndex";
    case Opcode::summary_offset:
      return "SummaryOffset";
    case Opcode::data_end:
      return "DataEnd";
  }
  return "record";
}

std::uint64_t IndexEntries::time(std::size_t entry) const {
  std::uint64_t value = 0;
  std::memcpy(&value, entries.data() + entry * kEntryBytes, sizeof(value));
  return value;
}

std::uint64_t IndexEntries::offset(std::size_t entry) const {
  std::uint64_t value = 0;
  std::memcpy(&value, entries.data() + entry * kEntryBytes + sizeof(value), sizeof(value));
  return value;
}

}  // namespace rocinante::mcap
