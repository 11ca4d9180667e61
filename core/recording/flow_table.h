#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// A listening endpoint, as used in channel names. One that watches others' traffic (pcap://) has
/// no address of its own: its channels are named by the destination of each datagram.
struct ListenedEndpoint {
  Endpoint endpoint;
  SocketAddress bound;  ///< with the port that was bound
};

/// The key that separates streams of datagrams.
struct Flow {
  std::uint32_t endpoint = 0;
  SocketAddress sender;
  std::string_view source;  ///< SOURCE of packet text; empty when there is none
  bool is_packet_text = false;
  bool is_restated = false;  ///< restated by another program (`by=`)
  /// The destination, when it is not the endpoint's own address; borrowed.
  const SocketAddress* destination = nullptr;
  std::string_view subject = {};  ///< of a NATS message; borrowed
};

/// The channel of a flow.
struct FlowChannel {
  std::uint32_t endpoint = 0;
  std::string topic;
  std::string encoding;
  std::map<std::string, std::string> metadata;
};

/// The channel of each flow (docs/log-format.md, "Channels"). Beyond kFlowsAnEndpoint flows of an
/// endpoint, further ones share /udp/PORT/_many, so that a sender that changes its name or port
/// with every datagram fills neither memory nor log. Pure.
class FlowTable {
 public:
  static constexpr std::size_t kFlowsAnEndpoint = 4'096;
  /// MCAP allows 65,536 channels; some are ours.
  static constexpr std::size_t kFlows = 60'000;

  explicit FlowTable(std::vector<ListenedEndpoint> endpoints);

  /// The index of the flow's channel; a new one for a flow not seen before.
  std::size_t channelOf(const Flow& flow);
  /// By index, in order of first appearance.
  const std::vector<FlowChannel>& channels() const { return channels_; }

 private:
  struct Key {
    std::uint32_t endpoint;
    SocketAddress sender;
    std::string source;
    bool is_packet_text;
    bool is_restated;
    std::optional<SocketAddress> destination;
    std::string subject;
  };
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(const Flow& flow) const;
    std::size_t operator()(const Key& key) const;
  };
  struct Equal {
    using is_transparent = void;
    template <class A, class B>
    bool operator()(const A& a, const B& b) const {
      return a.endpoint == b.endpoint && a.sender == b.sender && a.source == b.source &&
             a.is_packet_text == b.is_packet_text && a.is_restated == b.is_restated &&
             a.subject == b.subject &&
             (a.destination ? b.destination && *a.destination == *b.destination : !b.destination);
    }
  };
  struct EndpointState {
    ListenedEndpoint listened;
    std::string root;  ///< "/udp/19960", "/udp/239.255.19.96:19960", "/subscribe/10.0.0.1:19960";
                       ///< of pcap:// "/udp", of a NATS server "/nats"
    std::size_t flows = 0;
    std::map<std::pair<bool, bool>, std::size_t> shared;  ///< _many, by encoding and restated
  };

  std::size_t sharedChannel(const Flow& flow);
  FlowChannel channelFor(const Flow& flow, bool shared) const;

  std::vector<EndpointState> endpoints_;
  std::unordered_map<Key, std::size_t, Hash, Equal> flows_;
  std::vector<FlowChannel> channels_;
};

}  // namespace rocinante
