#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/retention.h"
#include "recorder/pieces/note_box.h"
#include "recorder/pieces/piece_closer.h"

namespace rocinante {

/// The finished pieces of a recording: closes them in the background, deletes those that the limits
/// want gone, and says so.
class PieceShelf {
 public:
  /// `notes` must outlive it.
  PieceShelf(RetentionLimits limits, NoteBox& notes);

  /// Takes a piece that nothing will be added to. `about`: what it does not know of itself.
  void put(std::unique_ptr<PieceLog> piece, std::string reason, const PieceFacts& about = {});
  /// While another is being written that holds `current_bytes`.
  void keepLimits(std::optional<std::uint64_t> current_bytes);
  /// Looks at what was done since. The first piece that could not be closed well is the answer.
  Status settle();
  /// The same once everything is done.
  Status finish();

  /// A piece of this recording lies there.
  bool holds(const std::filesystem::path& path) const { return retention_.holds(path); }
  /// Of everything ever put here.
  std::uint64_t bytesEver() const { return bytes_ever_; }
  /// What the disk refused of it, by flow.
  const std::vector<std::uint64_t>& refusedByFlow() const { return refused_; }
  RecordedFiles files() const;

 private:
  Status settle(std::vector<PieceCloser::Done> done);

  NoteBox& notes_;
  RetentionLimits limits_;
  Retention retention_;
  std::uint64_t bytes_ever_ = 0;
  std::vector<std::uint64_t> refused_;
  bool too_large_told_ = false;
  PieceCloser closer_;
};

}  // namespace rocinante
