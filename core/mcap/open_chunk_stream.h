#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mcap/record_stepper.h"

namespace rocinante::mcap {

/// Expands a zstd chunk that is still being written, piece by piece, and returns its records as
/// they become whole (docs/log-format.md, "The open chunk"). Errors describe the fault of the
/// chunk; the caller adds its position.
class OpenChunkStream {
 public:
  OpenChunkStream();
  ~OpenChunkStream();
  OpenChunkStream(OpenChunkStream&&) noexcept;
  OpenChunkStream& operator=(OpenChunkStream&&) noexcept;

  /// Starts over.
  void begin();

  /// Takes the next stored bytes and returns how many of them belong to the chunk: fewer than all
  /// when it has ended() there. Call it when next() returns nothing more.
  Result<std::size_t> feed(ByteView stored);

  /// The next whole record, with its offset in the expanded chunk; valid until the next call. Empty
  /// when there is none yet.
  Result<std::optional<Record>> next();

  /// The end of the chunk was reached.
  bool ended() const;
  /// Size or checksum of the expanded records so far.
  std::uint64_t expandedBytes() const;
  std::uint32_t crc() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante::mcap
