#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/capture_sink.h"
#include "core/recording/piece_log.h"
#include "core/recording/piece_namer.h"
#include "recorder/pieces/piece_shelf.h"

namespace rocinante {

/// When a recording begins a new piece by itself; with neither, only on request.
struct SplitRule {
  std::uint64_t size_bytes = 0;  ///< 0: never. Approximate size of a piece
  Nanoseconds time{0};           ///< 0: never. Interval, counted from the session's origin
};

/// Records into a sequence of self-contained logs: each opens with a keyframe of what preceded it.
/// A single log is a sequence of one. A seam lies between two log times where no restatement is
/// unfinished, if such a place comes within a second; every datagram is in exactly one piece.
/// Another thread closes the old piece and deletes pieces beyond the limits. When the next piece
/// cannot be created, the recording continues in the old one, reports it and tries again.
class PieceSequence final : public CaptureSink {
 public:
  using MakePiece = std::function<Result<MadePiece>(LogTime start, const PieceNamer::Ours& ours)>;

  struct Options {
    SplitRule split;
    RetentionLimits limits;
    KeyframeOptions keyframes;
    MakePiece make_next;  ///< empty: a single piece
  };

  /// `notes` must outlive it.
  PieceSequence(MadePiece first, Options options, NoteBox& notes);

  Status begin(const SessionState& preceding, LogTime moment) override;
  bool seamDue(LogTime time) override;
  Status seam(LogTime time) override;
  Status write(const CapturedDatagram& datagram) override;
  Status writeLoss(const LossSpan& span) override { return piece_->writeLoss(span); }
  Status writeStep(const ClockStep& step) override { return piece_->writeStep(step); }
  Status flush(LogTime reached, SteadyTime now) override;
  Status flushAll() override { return piece_->flushAll(); }
  Status close(const std::string& reason) override;
  void askForSeam() override { asked_ = true; }
  std::uint64_t bytesWritten() const override { return shelf_.bytesEver() + piece_->bytes(); }
  std::vector<std::uint64_t> refusedByFlow() const override;
  RecordedFiles files() const override;

 private:
  bool wanted(LogTime time) const;
  void noteSize();
  void tellDisturbance();

  Options options_;
  NoteBox& notes_;
  std::unique_ptr<PieceLog> piece_;
  PieceShelf shelf_;
  std::optional<LogTime> origin_;     ///< of the session: its first captured datagram
  std::optional<LogTime> time_cell_;  ///< start of the current --split-time interval
  bool asked_ = false;
  bool full_ = false;
  std::uint64_t opening_bytes_ = 0;  ///< bytes of this piece before its first datagram
  std::uint64_t seen_bytes_ = 0;
  std::uint64_t largest_step_ = 0;  ///< largest growth of the piece in one step
  std::optional<LogTime> wanted_since_;
  std::optional<LogTime> retry_at_;  ///< earliest retry after the next piece could not be created
  std::string last_trouble_;
};

}  // namespace rocinante
