#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// A file made by this recording, identified by its inode: another file may have the same name by
/// now.
struct PieceFile {
  std::filesystem::path path;
  ::dev_t device = 0;
  ::ino_t inode = 0;

  /// The file now at `path`.
  static PieceFile at(const std::filesystem::path& path);
  /// Whether this file is still at `path`.
  bool isThere() const;
};

/// The contents of a piece of a recording.
struct PieceFacts {
  PieceFile file;
  std::uint64_t packets = 0;  ///< written to it
  std::uint64_t refused = 0;  ///< by the disk
  std::uint64_t bytes = 0;
  std::optional<LogTime> start, end;  ///< of its datagrams
  /// Another program deleted, replaced or truncated the file while it was written.
  std::optional<std::string> trouble;
  /// For a ring's file: how often it was triggered, the first reason, and the time.
  std::uint64_t triggers = 0;
  std::string why;
  std::optional<LogTime> triggered;
  bool cut_short = false;  ///< the ring's memory was too small for the whole span
};

/// A count of deleted pieces.
struct DeletedPieces {
  std::uint64_t count = 0;
  std::uint64_t packets = 0;
  std::uint64_t bytes = 0;
};

/// The files of a recording, for its summary.
struct RecordedFiles {
  std::vector<PieceFacts> pieces;  ///< those kept, oldest first
  DeletedPieces deleted;
};

}  // namespace rocinante
