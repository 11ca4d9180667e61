#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/check/judges/presence_judge.h"
#include "core/check/judges/sender_judge.h"
#include "core/check/judges/stream_judge.h"
#include "core/net/datagram_source.h"
#include "core/recording/flow_table.h"
#include "recorder/spy/rate_meter.h"
#include "recorder/spy/spy_decoders.h"
#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Watches datagrams and keeps statistics: who sends, which sources and devices are active and how
/// often, and what `check` finds in a stream without a model. Keeps no datagram; memory is bounded
/// for any number of senders. One thread; reads no clock.
class Spy {
 public:
  /// `began` is the start of watching; no later time may precede it.
  /// With `decoders`, what is not packet text is decoded.
  Spy(const std::vector<ListenedEndpoint>& endpoints, LogTime began,
      std::shared_ptr<const decode::DecoderSet> decoders = nullptr);

  void add(std::size_t endpoint, const ReceivedDatagram& datagram, LogTime arrived);
  /// Sets the endpoint's drop count so far, and its other input counts.
  void setDropped(std::size_t endpoint, std::uint64_t dropped, const InputCounts& counts = {},
                  Account left_out = {});

  SpyReport report(LogTime now);

 private:
  /// Found by the fold, of `joints` alone.
  static constexpr std::array kOrderFaults{PacketFault::order_mismatch, PacketFault::unknown_order};
  struct Sender {
    SpySender seen;
    RateMeter rate;
    LogTime last{};
  };
  struct Source {
    std::vector<std::string> senders;
    std::string last_sender;
    std::uint64_t turns = 0;
    std::uint64_t restated = 0;
    /// Faults of the fold that were reported already.
    std::array<std::uint64_t, kOrderFaults.size()> mismatches{};
    RateMeter rate;
    LogTime last{};
    std::optional<Nanoseconds> clock_offset;
  };
  struct Device {
    std::vector<std::string> sources;
    std::uint64_t statements = 0, changes = 0;
    RateMeter rate;
    std::optional<std::size_t> values;  ///< hash of the values after the last statement
    PresenceJudge presence;
    std::uint32_t driver = TwoSources::kNobody, poser = TwoSources::kNobody;
    TwoSources drivers, posers;
  };

  struct Event {
    std::uint64_t count = 0;
    LogTime last{};
  };

  Sender* senderFor(std::size_t endpoint, const ReceivedDatagram& datagram);
  void readPacket(const StreamJudge::Judged& judged, const std::string& sender);
  static void hearSender(Source& source, const std::string& sender);
  void readMismatches(const Packet& packet, const PacketPlace& place, const std::string& sender);
  /// Null beyond the limit of devices.
  Device* deviceNamed(std::string_view name);
  void readPresence(const Statement& statement, const PacketPlace& place);
  void readStatement(const Statement& statement, std::string_view source, const PacketPlace& place);
  void readEvents(LogTime arrived);
  void readFaults(std::span<const FaultAt> faults, ByteView payload, const std::string& sender);
  SpyDevice deviceReport(const std::string& name, const DeviceState& state, LogTime now);
  /// What `check` finds in the stream, its sources first.
  Findings judgements(LogTime now) const;

  LogTime began_;
  LogTime reached_;
  std::vector<SpyEndpoint> endpoints_;
  std::vector<LogTime> endpoint_last_;
  std::vector<Sender> senders_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> sender_by_address_;
  std::uint64_t more_senders_ = 0;
  std::map<std::string, Source, std::less<>> sources_;
  std::map<std::string, Device, std::less<>> devices_;
  std::map<std::pair<std::string, std::string>, Event> events_;  ///< by source and text
  std::uint64_t more_events_ = 0;
  std::array<SpyFault, kPacketFaultCount> faults_;
  StreamJudge stream_;
  std::optional<SpyDecoders> decoders_;
};

}  // namespace rocinante
