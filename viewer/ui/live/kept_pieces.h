#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/foreign/decode/decoder_set.h"
#include "core/recording/capture_sink.h"
#include "core/recording/piece_log.h"
#include "core/recording/retention.h"
#include "viewer/ui/live/keep_limits.h"

namespace rocinante {

/// Keeps the last part of a live session as a sequence of self-contained logs in one folder: a
/// tenth of the limits each, so that deleting the oldest loses little. A piece can be finished at
/// any moment, also in silence; the next one is made when there is something to put into it. On one
/// thread; starts none.
class KeptPieces final : public CaptureSink {
 public:
  /// `decoders`, if any, are attached to each piece.
  KeptPieces(std::filesystem::path folder, const KeepLimits& limits,
             std::shared_ptr<const decode::DecoderSet> decoders = nullptr);

  /// The piece that has everything before `moment` is to be finished by flush().
  void finishBefore(LogTime moment) { finish_at_ = moment; }
  /// While true nothing is deleted.
  void hold(bool held) { held_ = held; }
  /// The first piece that is still kept; empty: none yet.
  std::filesystem::path first() const;
  /// All pieces that are finished, oldest first.
  std::vector<std::filesystem::path> finished() const;
  /// Everything before this is in finished pieces.
  LogTime finishedUntil() const { return finished_until_; }
  /// Of the pieces that are kept.
  std::uint64_t bytes() const;
  /// Another program deleted, replaced or truncated a piece: the sentence, once.
  std::optional<std::string> takeDisturbance();

  Status begin(const SessionState&, LogTime) override { return {}; }
  bool seamDue(LogTime time) override;
  Status seam(LogTime time) override;
  Status write(const CapturedDatagram& datagram) override;
  Status writeLoss(const LossSpan& span) override;
  Status writeStep(const ClockStep& step) override;
  Status flush(LogTime reached, SteadyTime now) override;
  Status flushAll() override { return piece_ ? piece_->flushAll() : Status{}; }
  Status close(const std::string& reason) override;
  std::uint64_t bytesWritten() const override {
    return bytes_ever_ + (piece_ ? piece_->bytes() : 0);
  }
  std::vector<std::uint64_t> refusedByFlow() const override;

 private:
  Status openPiece(LogTime time);
  Status closePiece(const std::string& reason);
  void deleteSurplus();

  std::filesystem::path folder_;
  KeepLimits limits_;
  std::shared_ptr<const decode::DecoderSet> decoders_;
  std::string session_id_;
  std::uint64_t made_ = 0;
  std::unique_ptr<PieceLog> piece_;  ///< null between two pieces
  SessionState state_;               ///< at the end of the last finished piece
  std::optional<LogTime> origin_;
  std::optional<LogTime> piece_began_;
  std::optional<LogTime> seam_wanted_;
  std::vector<LossSpan> waiting_losses_;  ///< between two pieces
  std::vector<ClockStep> waiting_steps_;
  std::vector<std::uint64_t> refused_;  ///< by flow, in finished pieces
  Retention retention_;
  LogTime reached_{};
  std::optional<LogTime> finish_at_;
  LogTime finished_until_{};
  std::uint64_t bytes_ever_ = 0;
  bool held_ = false;
  std::optional<std::string> disturbance_;
};

}  // namespace rocinante
