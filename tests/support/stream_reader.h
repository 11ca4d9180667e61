#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/base/result.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"

namespace rocinante::test {

/// Reads an MCAP file strictly from its first record to its footer: the first breach of the format
/// is an error. (LogReader continues after damage.) Chunks are expanded, their CRC is checked, and
/// their records are returned instead of them.
class StreamReader {
 public:
  /// damaged when the file does not start with the magic. `file` must outlive the reader.
  static Result<StreamReader> open(ByteView file) {
    if (isMagic(file.first(std::min(file.size(), mcap::magic().size())))) return StreamReader(file);
    return damagedAt("the file does not start with the MCAP magic", 0);
  }

  /// The next record, valid until the next call; its offset is in the file, or in the expanded
  /// chunk. Empty after the footer, which the closing magic must follow.
  Result<std::optional<mcap::Record>> next() {
    while (!ended_) {
      if (!chunk_.atEnd()) {
        if (const auto record = chunk_.next()) return record;
        return damagedAt("a record reaches past the end of its chunk", chunk_offset_);
      }
      const std::optional<mcap::Record> record = steps_.next();
      if (!record) {
        return damagedAt("a record reaches past the end of the file", steps_.position());
      }
      if (record->opcode == mcap::Opcode::invalid) {
        return damagedAt("a record has opcode 0", record->offset);
      }
      if (record->opcode == mcap::Opcode::footer) {
        if (!isMagic(file_.subspan(static_cast<std::size_t>(record->end())))) {
          return damagedAt("the file does not end with the magic after its footer", record->end());
        }
        ended_ = true;
      }
      if (record->opcode != mcap::Opcode::chunk) return record;
      if (Status expanded = expand(*record); !expanded) return expanded.error();
    }
    return std::optional<mcap::Record>();
  }

 private:
  explicit StreamReader(ByteView file) : file_(file), steps_(file, mcap::magic().size()) {}

  static bool isMagic(ByteView bytes) { return std::ranges::equal(bytes, mcap::magic()); }
  static Error damagedAt(std::string what, std::uint64_t offset) {
    return {ErrorKind::damaged, std::move(what), fmt::format("byte {}", offset)};
  }

  Status expand(const mcap::Record& record) {
    mcap::Chunk chunk;
    if (!mcap::parse(record.content, chunk)) {
      return damagedAt("the chunk's lengths do not fit the chunk", record.offset);
    }
    const Result<ByteView> records = expander_.expand(chunk, scratch_);
    if (!records) {
      return Error{records.error().kind, records.error().what,
                   fmt::format("byte {}", record.offset)};
    }
    chunk_ = mcap::RecordStepper(*records);
    chunk_offset_ = record.offset;
    return {};
  }

  ByteView file_;
  mcap::RecordStepper steps_;
  bool ended_ = false;
  mcap::ChunkExpander expander_;
  mcap::Scratch scratch_;
  mcap::RecordStepper chunk_{ByteView()};
  std::uint64_t chunk_offset_ = 0;  ///< of the chunk in the file, for errors
};

}  // namespace rocinante::test
