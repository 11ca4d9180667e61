#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/recording/capture_sink.h"
#include "core/recording/condition.h"
#include "recorder/pieces/piece_sequence.h"
#include "recorder/pieces/ring_buffer.h"

namespace rocinante {

/// What a ring keeps.
struct RingRule {
  Nanoseconds span{};  ///< before a trigger
  Nanoseconds after{0};
  std::uint64_t max_bytes = std::uint64_t{256} << 20U;  ///< of memory, whatever the rate
};

/// A flight recorder: keeps the last `span` of a session in memory and writes nothing, until it is
/// triggered; then all of that, and what comes for `after` more, becomes a log of its own, which
/// opens with a keyframe of the state before its first datagram. Triggered again while that file is
/// being written, it goes on in the same one; later, in a new one. The file is written little by
/// little, as datagrams come: what is in memory at its end stays there for the next.
class RingRecording final : public CaptureSink {
 public:
  struct Options {
    RingRule ring;
    RetentionLimits limits;  ///< of the files
    KeyframeOptions keyframes;
    PieceSequence::MakePiece make;
    std::vector<Condition> triggers;
  };

  RingRecording(Options options, NoteBox& notes);

  Status begin(const SessionState& preceding, LogTime moment) override;
  bool seamDue(LogTime) override { return false; }
  Status seam(LogTime) override { return {}; }
  /// None of these fails: a file that cannot be made or written is told, and the ring goes on.
  Status write(const CapturedDatagram& datagram) override;
  Status writeLoss(const LossSpan& span) override;
  Status writeStep(const ClockStep& step) override;
  Status flush(LogTime reached, SteadyTime now) override;
  Status flushAll() override { return {}; }
  Status close(const std::string& reason) override;
  void askForSeam() override {}
  void trigger(LogTime moment, const std::string& why) override;
  std::uint64_t bytesWritten() const override {
    return shelf_.bytesEver() + (file_ ? file_->bytes() : 0);
  }
  /// Of files, not of the session: what the ring holds is not lost.
  std::vector<std::uint64_t> refusedByFlow() const override { return {}; }
  RecordedFiles files() const override { return shelf_.files(); }
  Nanoseconds held() const override;

 private:
  void add(const RingBuffer::Item& item);
  void dropFront();
  void dropOld(LogTime now);
  void triggerBySilence(LogTime reached);
  void startFile(LogTime moment, const std::string& why);
  void fold(const RingBuffer::Item& item, SessionState& state);
  RingBuffer::Place placeToBegin(LogTime from, SessionState& state);
  void writeSome(std::uint64_t most);
  Status writeItem(const RingBuffer::Item& item);
  void closeFile(const std::string& reason);

  Options options_;
  NoteBox& notes_;
  ConditionWatch triggers_;
  RingBuffer ring_;
  std::vector<std::optional<FlowChannel>> channels_;  ///< by flow
  SessionState tail_;  ///< the fold of everything that has left the ring
  PacketTextDecoder decoder_;
  LogTime last_{};                        ///< of any item
  std::optional<LogTime> dropped_early_;  ///< the latest item that had to go before its time

  std::unique_ptr<PieceLog> file_;
  RingBuffer::Place next_;  ///< what the file takes next
  LogTime until_{};         ///< what comes later is not for the file
  PieceFacts about_file_;
  std::optional<LogTime> origin_;

  PieceShelf shelf_;
};

}  // namespace rocinante
