#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mcap/stream_reader.h"

namespace rocinante::mcap {

/// Expands a zstd chunk that is still being written, piece by piece, and gives its records as they
/// become whole (docs/log-format.md, "The open chunk"). Errors say what is wrong with the chunk;
/// where it lies is for the caller to add.
class OpenChunkStream {
 public:
  OpenChunkStream();
  ~OpenChunkStream();
  OpenChunkStream(OpenChunkStream&&) noexcept;
  OpenChunkStream& operator=(OpenChunkStream&&) noexcept;

  /// Begins anew.
  void begin();

  /// Takes the next stored bytes and answers how many of them belong to the chunk: fewer than all
  /// when it has ended() there. To be called when next() has nothing more.
  Result<std::size_t> feed(ByteView stored);

  /// The next whole record, its offset that in the expanded chunk; valid until the next call. Empty
  /// when there is none yet.
  Result<std::optional<Record>> next();

  /// The end of the chunk was seen.
  bool ended() const;
  /// Of the expanded records so far.
  std::uint64_t expandedBytes() const;
  std::uint32_t crc() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante::mcap
