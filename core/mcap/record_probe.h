#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/bytes.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {

/// Judges whether bytes begin a record where nothing else says so: after damage. One per file.
class RecordProbe {
 public:
  explicit RecordProbe(ByteView file) : file_(file) {}

  /// True when the bytes at `offset` begin a credible record: a known opcode, lengths that fit, and
  /// another record or the end of the file after it.
  bool plausibleAt(std::uint64_t offset);
  /// The first offset behind `offset` that begins a credible record at which reading may resume;
  /// the end of the file when there is none.
  std::uint64_t resumeBehind(std::uint64_t offset);

 private:
  bool resumesAt(std::uint64_t offset);
  bool plausible(const mcap::Record& record);
  template <class T>
  bool parses(ByteView content);

  ByteView file_;
  /// Bytes that may still be parsed for guesses: a hostile file must not make the reader scan the
  /// whole file from each of its bytes.
  std::uint64_t budget_bytes_ = std::uint64_t{256} << 20U;
};

/// One of the ways that a chunk is stored.
bool knownCompression(std::string_view name);
/// The name, borrowed from the file only if it is unknown.
std::string_view compressionName(std::string_view name);

}  // namespace rocinante
