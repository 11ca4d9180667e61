#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/recording/capture_sink.h"
#include "core/recording/condition.h"
#include "core/recording/flow_table.h"
#include "core/recording/hand_over.h"
#include "core/recording/loss_ledger.h"
#include "core/recording/reorder_window.h"

namespace rocinante {

/// Where a recording begins and ends of itself. Nothing said: with the first datagram, and never.
struct CaptureLimits {
  std::optional<LogTime> until;         ///< datagrams from here on are not of the session
  std::optional<Nanoseconds> duration;  ///< the same, counted from the datagram that begins it
  std::optional<std::uint64_t> max_packets;
  std::vector<Condition> start_on;  ///< the datagram that meets one of these is the first
  std::vector<Condition> stop_on;   ///< the datagram that meets one of these is the last
};

/// What became of the datagrams of one endpoint: sent = recorded + kernel + queue + disk.
struct EndpointAccount {
  ListenedEndpoint listened;
  std::uint64_t recorded = 0;
  LossCounts losses;
};

/// The writing half of a recording: takes what the receiving thread handed over, puts it in order
/// of time, finds each datagram's channel, and tells a sink of datagrams, losses and clock steps.
/// Until the recording begins it only follows the session's state. One thread; reads no clock.
class CaptureWriter {
 public:
  CaptureWriter(std::unique_ptr<CaptureSink> sink, std::vector<ListenedEndpoint> endpoints,
                CaptureLimits limits);

  /// Writes what is ripe. Blocks that were written whole go back to `blocks`. A sink that refuses
  /// is remembered: what follows is counted as lost to the disk.
  void write(TakenOver taken, HandOver& blocks);
  /// Now and then, also when nothing comes: bounds what a crash can lose.
  void flush(SteadyTime now);
  /// Writes everything that still waits, the losses, the end.
  void close(const std::string& reason, HandOver& blocks);
  /// See CaptureSink.
  void askForSeam() { sink_->askForSeam(); }
  void trigger(const std::string& why) { sink_->trigger(drained_until_, why); }

  /// The recording has begun: at once, where nothing has to be met first.
  bool started() const { return started_; }
  /// A limit is reached or the sink refused: nothing more will be kept.
  bool over() const { return end_.has_value() || trouble_.has_value(); }
  /// Why it ended of itself: "packets", "duration", "condition"; empty when it did not.
  const std::string& endReason() const { return end_reason_; }
  /// The first refusal of the sink.
  const std::optional<Error>& trouble() const { return trouble_; }

  std::uint64_t packets() const { return packets_; }
  /// Of packets(), those that someone else restates (`by=`): no messages of the session.
  std::uint64_t restated() const { return restated_; }
  /// Heard before the recording began.
  std::uint64_t packetsBefore() const { return packets_before_; }
  std::uint64_t payloadBytes() const { return payload_bytes_; }
  std::uint64_t logBytes() const { return sink_->bytesWritten(); }
  RecordedFiles files() const { return sink_->files(); }
  Nanoseconds held() const { return sink_->held(); }
  std::uint64_t lost() const;
  std::size_t channelCount() const { return sequences_.size(); }
  std::size_t late() const { return window_.late(); }
  /// Exact after close().
  std::vector<EndpointAccount> accounts() const;

 private:
  void writeHeld(const ReorderWindow::Held& held, HandOver& blocks);
  void takeDatagram(const Arrival& arrival, LogTime time, ByteView payload);
  /// Follows the state until a condition is met; true from then on.
  bool begins(LogTime time, const Packet* packet);
  void writeDatagram(const Arrival& arrival, LogTime time, ByteView payload, const Packet* packet);
  /// The ledger has those of this turn that are over by `time`.
  void enterLosses(LogTime time);
  void writeLosses(const std::vector<EndpointLoss>& losses);
  void writeSteps(LogTime reached);
  void endAt(LogTime time, const char* reason);
  void release(DatagramBlock* block, HandOver& blocks);
  std::vector<EndpointLoss> newDiskLosses();
  /// The flow that a datagram belongs to; `packet` is what it was decoded to, if it could be.
  std::size_t flowOf(const Arrival& arrival, ByteView payload, const Packet* packet);
  bool keep(const Status& done);

  std::unique_ptr<CaptureSink> sink_;
  std::vector<ListenedEndpoint> endpoints_;
  CaptureLimits limits_;
  FlowTable flows_;
  PacketTextDecoder decoder_;
  ReorderWindow window_;
  LossLedger ledger_;
  std::vector<std::uint32_t> sequences_;  ///< the next one, by flow
  std::vector<std::uint64_t> taken_;      ///< by endpoint: given to the sink
  std::vector<ClockStep> steps_;
  std::vector<EndpointLoss> new_losses_;  ///< told in this turn of write()

  bool started_ = false;
  ConditionWatch start_;
  ConditionWatch stop_;
  SessionState before_;  ///< the fold of what was heard before the recording began

  struct BlockInUse {
    std::unique_ptr<DatagramBlock> block;
    std::size_t waiting = 0;  ///< arrivals that were not let go yet
  };
  std::unordered_map<DatagramBlock*, BlockInUse> blocks_;

  std::uint64_t packets_ = 0;
  std::uint64_t packets_before_ = 0;
  std::uint64_t restated_ = 0;
  std::uint64_t payload_bytes_ = 0;
  LogTime drained_until_{};
  LogTime last_time_{};
  LogTime unsaved_since_{};  ///< the first message that may not stand in the file yet
  std::uint64_t saved_bytes_ = 0;
  std::optional<LogTime> end_;
  std::string end_reason_;
  std::optional<Error> trouble_;
};

}  // namespace rocinante
