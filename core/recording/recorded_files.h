#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// A file that this recording made, so that it is known again: a name alone can stand for another
/// file by now.
struct PieceFile {
  std::filesystem::path path;
  ::dev_t device = 0;
  ::ino_t inode = 0;

  /// What lies at `path` now.
  static PieceFile at(const std::filesystem::path& path);
  /// Still what lies at `path`.
  bool isThere() const;
};

/// What stands in a piece of a recording.
struct PieceFacts {
  PieceFile file;
  std::uint64_t packets = 0;  ///< given to it and not refused by the disk
  std::uint64_t refused = 0;  ///< by the disk
  std::uint64_t bytes = 0;
  std::optional<LogTime> start, end;  ///< of its datagrams
  /// Another program deleted, replaced or cut the file while it was written.
  std::optional<std::string> trouble;
  /// Of a ring's file: how often it was asked for, why at first, and when.
  std::uint64_t triggers = 0;
  std::string why;
  std::optional<LogTime> triggered;
  bool cut_short = false;  ///< the ring's memory did not hold all that was to be kept
};

/// Pieces that were deleted.
struct DeletedPieces {
  std::uint64_t count = 0;
  std::uint64_t packets = 0;
  std::uint64_t bytes = 0;
};

/// What a recording left: what its summary tells of its files.
struct RecordedFiles {
  std::vector<PieceFacts> pieces;  ///< those that stay, oldest first
  DeletedPieces deleted;
};

}  // namespace rocinante
