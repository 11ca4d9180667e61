#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rocinante::mcap {

/// Contents and layout of a Writer's file.
struct WriterOptions {
  bool chunked = true;
  std::optional<int> zstd_level = 1;    ///< empty: chunks are not compressed
  std::size_t chunk_bytes = 1U << 20U;  ///< uncompressed; a chunk of this size is closed
  bool message_indexes = true;
  bool chunk_indexes = true;
  bool attachment_indexes = true;
  bool metadata_indexes = true;
  bool statistics = true;
  bool repeat_schemas = true;   ///< in the summary
  bool repeat_channels = true;  ///< in the summary
  bool summary_offsets = true;
  /// Disk space that stays free, in addition to the room for indexes and summary, for writes after
  /// the disk has refused.
  std::uint64_t closing_room_bytes = 0;
};

}  // namespace rocinante::mcap
