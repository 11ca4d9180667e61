#include "core/mcap/stream_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"

namespace rocinante::mcap {
namespace {

Error damagedAt(std::string what, std::uint64_t offset) {
  return Error{ErrorKind::damaged, std::move(what), fmt::format("byte {}", offset)};
}

}  // namespace

std::optional<Record> recordAt(ByteView bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < kPrefixBytes) return std::nullopt;
  const ByteView rest = bytes.subspan(static_cast<std::size_t>(offset));
  std::uint64_t length = 0;
  std::memcpy(&length, rest.data() + 1, sizeof(length));
  if (length > rest.size() - kPrefixBytes) return std::nullopt;
  return Record{static_cast<Opcode>(rest[0]), offset,
                rest.subspan(kPrefixBytes, static_cast<std::size_t>(length))};
}

Result<StreamReader> StreamReader::open(ByteView file) {
  if (file.size() < magic().size() || !std::ranges::equal(file.first(magic().size()), magic())) {
    return damagedAt("the file does not start with the MCAP magic", 0);
  }
  return StreamReader(file);
}

Result<std::optional<Record>> StreamReader::nextInChunk() {
  const std::optional<Record> record = recordAt(chunk_, chunk_position_);
  if (!record) return damagedAt("a record reaches past the end of its chunk", chunk_offset_);
  chunk_position_ = record->end();
  return std::optional<Record>(*record);
}

Result<std::optional<Record>> StreamReader::next() {
  if (ended_) return std::optional<Record>();
  if (chunk_position_ < chunk_.size()) return nextInChunk();
  const std::optional<Record> record = recordAt(file_, position_);
  if (!record) return damagedAt("a record reaches past the end of the file", position_);
  if (record->opcode == Opcode::invalid) return damagedAt("a record has opcode 0", position_);
  position_ = record->end();
  if (record->opcode == Opcode::footer) {
    if (!std::ranges::equal(file_.subspan(static_cast<std::size_t>(position_)), magic())) {
      return damagedAt("the file does not end with the magic after its footer", position_);
    }
    ended_ = true;
  }
  if (record->opcode != Opcode::chunk) return std::optional<Record>(*record);

  Chunk chunk;
  if (!parse(record->content, chunk)) {
    return damagedAt("the chunk's lengths do not fit the chunk", record->offset);
  }
  Result<ByteView> records = expander_.expand(chunk, scratch_);
  if (!records) {
    return Error{records.error().kind, records.error().what,
                 fmt::format("byte {}", record->offset)};
  }
  chunk_ = *records;
  chunk_position_ = 0;
  chunk_offset_ = record->offset;
  return next();
}

}  // namespace rocinante::mcap
