#pragma once

#include <cstdint>
#include <optional>

#include "core/mcap/records.h"

namespace rocinante::mcap {

/// A record as stored. Borrowed.
struct Record {
  Opcode opcode = Opcode::invalid;
  std::uint64_t offset = 0;  ///< of the opcode
  ByteView content;

  std::uint64_t end() const { return offset + kPrefixBytes + content.size(); }
};

/// The record at `offset` of `bytes`; empty when its prefix or its content would extend past the
/// end.
std::optional<Record> recordAt(ByteView bytes, std::uint64_t offset);

/// Steps over the records of a file, a part of one or an expanded chunk, which it borrows. Judges
/// nothing but their lengths.
class RecordStepper {
 public:
  explicit RecordStepper(ByteView bytes, std::uint64_t position = 0)
      : bytes_(bytes), position_(position) {}

  /// The record at position(), stepped over. Empty at the end, and where no whole record is.
  std::optional<Record> next() {
    const std::optional<Record> record = peek();
    if (record) position_ = record->end();
    return record;
  }
  /// The same record, not stepped over.
  std::optional<Record> peek() const { return recordAt(bytes_, position_); }

  std::uint64_t position() const { return position_; }
  void moveTo(std::uint64_t position) { position_ = position; }
  bool atEnd() const { return position_ >= bytes_.size(); }

 private:
  ByteView bytes_;
  std::uint64_t position_;
};

}  // namespace rocinante::mcap
