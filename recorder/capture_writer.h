#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/session/session_writer.h"
#include "recorder/flow_table.h"
#include "recorder/hand_over.h"
#include "recorder/loss_ledger.h"
#include "recorder/reorder_window.h"

namespace rocinante {

/// Where a recording ends of itself.
struct CaptureLimits {
  std::optional<LogTime> until;  ///< datagrams from here on are not of the session
  std::optional<std::uint64_t> max_packets;
};

/// What became of the datagrams of one endpoint: sent = recorded + kernel + queue + disk.
struct EndpointAccount {
  ListenedEndpoint listened;
  std::uint64_t recorded = 0;
  LossCounts losses;
};

/// The writing half of a recording: takes what the receiving thread handed over, puts it in order
/// of time, finds each datagram's channel, and writes datagrams, losses and clock steps to the log,
/// with a keyframe where one is due. One thread; reads no clock.
class CaptureWriter {
 public:
  CaptureWriter(LogWriter log, std::vector<ListenedEndpoint> endpoints, CaptureLimits limits,
                const KeyframeOptions& keyframes = {});

  /// Writes what is ripe. Blocks that were written whole go back to `blocks`. A log that refuses is
  /// remembered: what follows is counted as lost to the disk.
  void write(TakenOver taken, HandOver& blocks);
  /// Now and then, also when nothing comes: bounds what a crash can lose.
  void flush(SteadyTime now);
  /// Writes everything that still waits, the losses, the end.
  void close(const std::string& reason, SteadyTime now, HandOver& blocks);

  /// A limit is reached or the log refused: nothing more will be kept.
  bool over() const { return end_.has_value() || trouble_.has_value(); }
  bool limitReached() const { return end_.has_value(); }
  /// The first refusal of the log.
  const std::optional<Error>& trouble() const { return trouble_; }

  std::uint64_t packets() const { return packets_; }
  /// Of packets(), those that someone else restates (`by=`): no messages of the session.
  std::uint64_t restated() const { return restated_; }
  std::uint64_t payloadBytes() const { return payload_bytes_; }
  std::uint64_t logBytes() const { return session_.log().bytesWritten(); }
  std::uint64_t lost() const;
  std::size_t channelCount() const { return flows_.channels().size(); }
  std::size_t late() const { return window_.late(); }
  /// Exact after close().
  std::vector<EndpointAccount> accounts() const;

 private:
  struct ChannelState {
    ChannelId id = 0;
    std::uint32_t sequence = 0;
  };

  void writeHeld(const ReorderWindow::Held& held, HandOver& blocks);
  void writeDatagram(const Arrival& arrival, LogTime time, ByteView payload);
  void writeLosses(const std::vector<EndpointLoss>& losses);
  void writeSteps(LogTime reached);
  void release(DatagramBlock* block, HandOver& blocks);
  std::vector<EndpointLoss> newDiskLosses();
  /// The flow that a datagram belongs to; `packet` is what it was decoded to, if it could be.
  std::size_t channelOf(const Arrival& arrival, ByteView payload, const Packet* packet);
  bool keep(const Status& done);

  SessionWriter session_;
  std::vector<ListenedEndpoint> endpoints_;
  CaptureLimits limits_;
  FlowTable flows_;
  PacketTextDecoder decoder_;
  ReorderWindow window_;
  LossLedger ledger_;
  std::vector<ChannelState> channels_;  ///< by index of flows_.channels()
  std::vector<std::uint64_t> taken_;    ///< by endpoint: given to the log
  std::optional<ChannelId> clock_channel_;
  std::uint32_t clock_sequence_ = 0;
  std::vector<ClockStep> steps_;

  struct BlockInUse {
    std::unique_ptr<DatagramBlock> block;
    std::size_t waiting = 0;  ///< arrivals that were not let go yet
  };
  std::unordered_map<DatagramBlock*, BlockInUse> blocks_;

  std::uint64_t packets_ = 0;
  std::uint64_t restated_ = 0;
  std::uint64_t payload_bytes_ = 0;
  LogTime last_time_{};
  LogTime unsaved_since_{};  ///< the first message that may not stand in the file yet
  std::uint64_t saved_bytes_ = 0;
  std::optional<LogTime> end_;
  std::optional<Error> trouble_;
};

}  // namespace rocinante
