#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/retention.h"
#include "recorder/pieces/note_box.h"
#include "recorder/pieces/piece_closer.h"

namespace rocinante {

/// The finished pieces of a recording: closes them in the background, deletes those beyond the
/// limits, and notes both.
class PieceShelf {
 public:
  /// `notes` must outlive it.
  PieceShelf(RetentionLimits limits, NoteBox& notes);

  /// Takes a finished piece. `about` holds what the piece does not know.
  void put(std::unique_ptr<PieceLog> piece, std::string reason, const PieceFacts& about = {});
  /// Enforces the limits while a piece of `current_bytes` is being written.
  void keepLimits(std::optional<std::uint64_t> current_bytes);
  /// Collects finished work. Returns the first failure to close a piece.
  Status settle();
  /// The same after everything is done.
  Status finish();

  /// True if a piece of this recording has this path.
  bool holds(const std::filesystem::path& path) const { return retention_.holds(path); }
  /// Total over all pieces put here.
  std::uint64_t bytesEver() const { return bytes_ever_; }
  /// Datagrams of those that the disk refused, by flow.
  const std::vector<std::uint64_t>& refusedByFlow() const { return refused_; }
  RecordedFiles files() const;

 private:
  Status settle(std::vector<PieceCloser::Done> done);

  NoteBox& notes_;
  RetentionLimits limits_;
  Retention retention_;
  std::uint64_t bytes_ever_ = 0;
  std::vector<std::uint64_t> refused_;
  bool too_large_reported_ = false;
  PieceCloser closer_;
};

}  // namespace rocinante
