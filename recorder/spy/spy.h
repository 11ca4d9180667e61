#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/recording/flow_table.h"
#include "recorder/spy/rate_meter.h"
#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Watches datagrams and keeps what explains them: who sends, which sources and devices speak and
/// how often, what is wrong with what they say. Needs no model and keeps no datagram; its memory is
/// bounded however many strangers send. One thread; reads no clock.
class Spy {
 public:
  /// `began` is the moment from which it watches; no later time may lie before it.
  Spy(const std::vector<ListenedEndpoint>& endpoints, LogTime began);

  void add(std::size_t endpoint, const ReceivedDatagram& datagram, LogTime arrived);
  /// The endpoint's drop count so far, and what else did not come through.
  void setDropped(std::size_t endpoint, std::uint64_t dropped, const InputCounts& counts = {});

  SpyReport report(LogTime now);

 private:
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
    std::uint64_t mismatches = 0;  ///< of the fold's, those told
    RateMeter rate;
    LogTime last{};
    std::optional<Nanoseconds> clock_offset;
  };
  struct Device {
    std::vector<std::string> sources;
    std::uint64_t statements = 0, changes = 0;
    RateMeter rate;
    std::optional<std::size_t> values;  ///< a hash of where it stood after the last of them
  };

  struct Event {
    std::uint64_t count = 0;
    LogTime last{};
  };

  Sender* senderFor(std::size_t endpoint, const ReceivedDatagram& datagram);
  void readPacket(const Packet& packet, ByteView payload, const std::string& sender,
                  LogTime arrived);
  static void hearSender(Source& source, const std::string& sender);
  void readMismatches(const Packet& packet, ByteView payload, const std::string& sender);
  void readStatement(const Statement& statement, std::string_view source, LogTime arrived);
  void readEvents(LogTime arrived);
  void readFaults(std::span<const FaultAt> faults, ByteView payload, const std::string& sender);
  SpyDevice deviceReport(const std::string& name, const DeviceState& state, LogTime now);

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
  PacketTextDecoder decoder_;
  SessionState state_;
  std::uint64_t datagrams_ = 0, packets_ = 0;
};

}  // namespace rocinante
