#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/bytes.h"
#include "core/mcap/stream_reader.h"

namespace rocinante {

/// Judges whether bytes begin a record, where nothing else says that one should be there: behind
/// damage. For one file.
class RecordProbe {
 public:
  explicit RecordProbe(ByteView file) : file_(file) {}

  /// True when the bytes at `offset` begin a record that can be believed: known by its opcode, with
  /// lengths that fit, and followed by another or by the end of the file.
  bool plausibleAt(std::uint64_t offset);
  /// The same, for the records that reading may go on with.
  bool resumesAt(std::uint64_t offset);

 private:
  bool plausible(const mcap::Record& record);
  template <class T>
  bool parses(ByteView content);

  ByteView file_;
  /// Bytes that may still be parsed for a guess: a hostile file must not make us look at all of it
  /// from each of its bytes.
  std::uint64_t budget_bytes_ = std::uint64_t{256} << 20U;
};

/// A chunk is stored in one of these ways.
bool knownCompression(std::string_view name);
/// The name, no longer borrowed from the file where it is a known one.
std::string_view compressionName(std::string_view name);

}  // namespace rocinante
