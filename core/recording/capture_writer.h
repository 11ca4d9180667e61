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

/// When a recording begins and ends by itself. By default: with the first datagram, and never.
struct CaptureLimits {
  std::optional<LogTime> until;         ///< datagrams from here on are not part of the session
  std::optional<Nanoseconds> duration;  ///< the same, relative to the first datagram
  std::optional<std::uint64_t> max_packets;
  std::vector<Condition> start_on;  ///< the datagram that meets one of these is the first
  std::vector<Condition> stop_on;   ///< the datagram that meets one of these is the last
};

/// The account of one endpoint's datagrams: sent = recorded + kernel + queue + disk.
struct EndpointAccount {
  ListenedEndpoint listened;
  std::uint64_t recorded = 0;
  LossCounts losses;
};

/// The writing half of a recording: takes blocks from the receiving thread, sorts their datagrams
/// by time, finds each one's channel, and passes datagrams, losses and clock steps to a sink. Until
/// the recording begins it only follows the session's state. One thread; reads no clock.
class CaptureWriter {
 public:
  /// With `octets`, what is not packet text is decoded by it; conditions see the packets made.
  CaptureWriter(std::unique_ptr<CaptureSink> sink, std::vector<ListenedEndpoint> endpoints,
                CaptureLimits limits, std::shared_ptr<OctetDecoder> octets = nullptr);

  /// Writes the datagrams that are due. Blocks that are fully written go back to `blocks`. A
  /// failure of the sink is remembered: later datagrams count as lost to the disk.
  void write(TakenOver taken, HandOver& blocks);
  /// To be called regularly, also when nothing arrives: bounds what a crash can lose.
  void flush(SteadyTime now);
  /// Writes what was taken so far to the file, so that a killed process does not lose it, and
  /// returns how many datagrams that is: the first ones received, recorded or before the start
  /// condition. Empty when the sink failed.
  std::optional<std::uint64_t> save();
  /// Writes everything still waiting, the losses, and the end.
  void close(const std::string& reason, HandOver& blocks);
  /// See CaptureSink.
  void askForSeam() { sink_->askForSeam(); }
  void trigger(const std::string& why) { sink_->trigger(drained_until_, why); }

  /// The recording has begun: at once, if there is no start condition.
  bool started() const { return started_; }
  /// A limit is reached or the sink failed: nothing more will be kept.
  bool over() const { return end_.has_value() || trouble_.has_value(); }
  /// Why it ended by itself: "packets", "duration", "condition"; empty when it did not.
  const std::string& endReason() const { return end_reason_; }
  /// The first failure of the sink.
  const std::optional<Error>& trouble() const { return trouble_; }

  std::uint64_t packets() const { return packets_; }
  /// The time of the first of them.
  std::optional<LogTime> firstTime() const { return first_time_; }
  /// Those of packets() that another program restated (`by=`): not messages of the session.
  std::uint64_t restated() const { return restated_; }
  /// Datagrams received before the recording began.
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
  /// Follows the state until a start condition is met; true from then on.
  bool begins(LogTime time, const Packet* packet);
  /// The same for what is not a packet, when it may be decoded.
  void takeOctets(const Arrival& arrival, LogTime time, ByteView payload);
  /// `packet`: what it is or, with `made`, what was made of it.
  void writeDatagram(const Arrival& arrival, LogTime time, ByteView payload, std::size_t flow,
                     const Packet* packet, const MadePacket* made);
  /// Ends the recording with this datagram if a limit or a condition says so.
  void endWith(LogTime time, const Packet* packet);
  /// Adds this turn's losses that ended by `time` to the ledger.
  void enterLosses(LogTime time);
  void writeLosses(const std::vector<EndpointLoss>& losses);
  void writeSteps(LogTime reached);
  void endAt(LogTime time, const char* reason);
  void release(DatagramBlock* block, HandOver& blocks);
  std::vector<EndpointLoss> newDiskLosses();
  /// The flow of a datagram; `packet` is the packet that it is, if it is one.
  static std::size_t flowOf(FlowTable& flows, const Arrival& arrival, ByteView payload,
                            const Packet* packet);
  bool keep(const Status& done);

  std::unique_ptr<CaptureSink> sink_;
  std::vector<ListenedEndpoint> endpoints_;
  CaptureLimits limits_;
  FlowTable flows_;
  PacketTextDecoder decoder_;
  std::shared_ptr<OctetDecoder> octets_;   ///< null: what is not packet text is not decoded
  std::optional<FlowTable> flows_before_;  ///< of octets before the recording begins
  ReorderWindow window_;
  LossLedger ledger_;
  std::vector<std::uint32_t> sequences_;  ///< the next one, by flow
  std::vector<std::uint64_t> taken_;      ///< by endpoint: given to the sink
  std::vector<ClockStep> steps_;
  std::vector<EndpointLoss> new_losses_;  ///< passed to this call of write()

  bool started_ = false;
  ConditionWatch start_;
  ConditionWatch stop_;
  SessionState before_;  ///< the fold of the datagrams before the recording began

  struct BlockInUse {
    std::unique_ptr<DatagramBlock> block;
    std::size_t waiting = 0;  ///< arrivals not written yet
  };
  std::unordered_map<DatagramBlock*, BlockInUse> blocks_;

  std::uint64_t packets_ = 0;
  std::uint64_t packets_before_ = 0;
  std::uint64_t restated_ = 0;
  std::uint64_t payload_bytes_ = 0;
  LogTime drained_until_{};
  std::optional<LogTime> first_time_;
  LogTime last_time_{};
  LogTime unsaved_since_{};  ///< the first message that may not be in the file yet
  std::uint64_t saved_bytes_ = 0;
  std::optional<LogTime> end_;
  std::string end_reason_;
  std::optional<Error> trouble_;
};

}  // namespace rocinante
