#pragma once

#include "core/base/bytes.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// Appends a whole record: opcode, length, content.
void append(Bytes& out, const Header& record);
void append(Bytes& out, const Footer& record);
void append(Bytes& out, const Schema& record);
void append(Bytes& out, const Channel& record);
void append(Bytes& out, const Message& record);
void append(Bytes& out, const Chunk& record);
void append(Bytes& out, const MessageIndex& record);
void append(Bytes& out, const ChunkIndex& record);
void append(Bytes& out, const Attachment& record);
void append(Bytes& out, const AttachmentIndex& record);
void append(Bytes& out, const Statistics& record);
void append(Bytes& out, const Metadata& record);
void append(Bytes& out, const MetadataIndex& record);
void append(Bytes& out, const SummaryOffset& record);
void append(Bytes& out, const DataEnd& record);

}  // namespace rocinante::mcap
