#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/recording/capture_sink.h"
#include "core/recording/condition.h"
#include "recorder/pieces/finding_trigger.h"
#include "recorder/pieces/piece_sequence.h"
#include "recorder/pieces/ring_buffer.h"

namespace rocinante {

/// Limits of a ring.
struct RingRule {
  Nanoseconds span{};  ///< before a trigger
  Nanoseconds after{0};
  std::uint64_t max_bytes = std::uint64_t{256} << 20U;  ///< memory, at any rate
};

/// A flight recorder: keeps the last `span` of a session in memory and writes nothing until it is
/// triggered. Then that span, and the next `after`, become a log of their own, which opens with a
/// keyframe of the state before its first datagram. A trigger while that file is being written
/// extends it; a later trigger starts a new file. The file is written gradually as datagrams come;
/// memory is kept for the next file.
class RingRecording final : public CaptureSink {
 public:
  struct Options {
    RingRule ring;
    RetentionLimits limits;  ///< for the files
    KeyframeOptions keyframes;
    PieceSequence::MakePiece make;
    std::vector<Condition> triggers;
    std::shared_ptr<FindingTrigger> watch;  ///< its findings trigger, too; null: none
  };

  RingRecording(Options options, NoteBox& notes);

  Status begin(const SessionState& preceding, LogTime moment) override;
  /// None of these fails: a file that cannot be created or written is noted, and the ring
  /// continues.
  Status write(const CapturedDatagram& datagram) override;
  Status writeLoss(const LossSpan& span) override;
  Status writeStep(const ClockStep& step) override;
  Status flush(LogTime reached, SteadyTime now) override;
  Status flushAll() override { return {}; }
  Status close(const std::string& reason) override;
  void trigger(LogTime moment, const std::string& why) override;
  std::uint64_t bytesWritten() const override {
    return shelf_.bytesEver() + (file_ ? file_->bytes() : 0);
  }
  /// Files refuse datagrams, but the session has not lost what the ring holds.
  std::vector<std::uint64_t> refusedByFlow() const override { return {}; }
  RecordedFiles files() const override { return shelf_.files(); }
  Nanoseconds held() const override;

 private:
  void add(const RingBuffer::Item& item);
  void dropFront();
  void dropOld(LogTime now);
  void triggerBySilence(LogTime reached);
  void triggerByFinding();
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
  /// By decoder: the metadata of its packets' channels, of the OctetDecoder.
  std::vector<const std::map<std::string, std::string>*> decoders_;
  SessionState tail_;  ///< fold of everything that has left the ring
  PacketTextDecoder decoder_;
  LogTime last_{};                        ///< of any item
  std::optional<LogTime> dropped_early_;  ///< the latest item that was dropped early

  std::unique_ptr<PieceLog> file_;
  RingBuffer::Place next_;  ///< next item for the file
  LogTime until_{};         ///< end of the file's span
  PieceFacts about_file_;
  std::optional<LogTime> origin_;

  PieceShelf shelf_;
};

}  // namespace rocinante
