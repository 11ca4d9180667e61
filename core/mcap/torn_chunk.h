#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/mcap/record_probe.h"
#include "core/mcap/records.h"

namespace rocinante {

/// A chunk that its own lengths do not describe: still open, cut off by the end of the file, or
/// with one of its two lengths damaged when the other gives its end.
struct TornChunk {
  mcap::Chunk chunk;                           ///< its records are those that are there
  std::uint64_t end = 0;                       ///< file offset behind them
  bool cut = false;                            ///< they may end inside a record or a zstd frame
  std::string cause;                           ///< one sentence for users
  std::optional<std::uint64_t> messages_lost;  ///< empty when it cannot be known
};

/// Empty when no such chunk begins at `offset`.
std::optional<TornChunk> tornChunkAt(ByteView file, std::uint64_t offset, RecordProbe& probe);

}  // namespace rocinante
