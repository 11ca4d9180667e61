#pragma once

#include <cstddef>
#include <optional>

#include "core/base/bytes.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// Empty when the content of the MessageIndex breaks the format.
std::optional<IndexEntries> indexEntries(ByteView content);

/// Reads a record from its content (without the prefix). Returns how many bytes its known fields
/// took: a later version may add fields after them, except to Message, DataEnd and Footer. Empty
/// when the content breaks the format: a length beyond the end, or a map whose pairs do not fill
/// its bytes exactly. Allocates nothing before its length is checked.
std::optional<std::size_t> parse(ByteView content, Header& out);
std::optional<std::size_t> parse(ByteView content, Footer& out);
std::optional<std::size_t> parse(ByteView content, Schema& out);
std::optional<std::size_t> parse(ByteView content, Channel& out);
std::optional<std::size_t> parse(ByteView content, Message& out);
std::optional<std::size_t> parse(ByteView content, Chunk& out);
std::optional<std::size_t> parse(ByteView content, MessageIndex& out);
std::optional<std::size_t> parse(ByteView content, ChunkIndex& out);
std::optional<std::size_t> parse(ByteView content, Attachment& out);
std::optional<std::size_t> parse(ByteView content, AttachmentIndex& out);
std::optional<std::size_t> parse(ByteView content, Statistics& out);
std::optional<std::size_t> parse(ByteView content, Metadata& out);
std::optional<std::size_t> parse(ByteView content, MetadataIndex& out);
std::optional<std::size_t> parse(ByteView content, SummaryOffset& out);
std::optional<std::size_t> parse(ByteView content, DataEnd& out);

}  // namespace rocinante::mcap
