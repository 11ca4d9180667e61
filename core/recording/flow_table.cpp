#include "core/recording/flow_table.h"

#include <fmt/format.h>

#include <cstring>

#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

template <class Any>
std::size_t hashOf(const Any& flow) {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  std::memcpy(&high, flow.sender.address.data(), 8);
  std::memcpy(&low, flow.sender.address.data() + 8, 8);
  std::uint64_t mixed = (std::uint64_t{flow.endpoint} << 32U) ^
                        (std::uint64_t{flow.sender.port} << 8U) ^ (flow.is_packet_text ? 1U : 0U) ^
                        (flow.is_restated ? 2U : 0U);
  if (flow.destination) {
    // Hostile traffic may choose both addresses. That can only make a few long chains, because the
    // number of flows is bounded.
    std::uint64_t host = 0;
    std::memcpy(&host, flow.destination->address.data() + (flow.destination->is_ipv6 ? 8 : 0), 8);
    mixed ^= (host * 0xD6E8FEB86659FD93U) + flow.destination->port;
  }
  for (const std::uint64_t part :
       {high, low, std::uint64_t{std::hash<std::string_view>{}(flow.source)},
        std::uint64_t{std::hash<std::string_view>{}(flow.subject)}}) {
    mixed = (mixed ^ part) * 0x9E3779B97F4A7C15U;
    mixed ^= mixed >> 29U;
  }
  return mixed;
}

/// The beginning of the topics of datagrams to `address`.
std::string rootOf(const SocketAddress& address) {
  if (address.isMulticast()) return "/udp/" + address.text();
  return fmt::format("/udp/{}", address.port);
}

std::string rootOf(const ListenedEndpoint& listened) {
  if (listened.endpoint.isPcap()) return "/udp";
  if (listened.endpoint.isNats()) return "/nats";
  if (!listened.endpoint.isSubscription()) return rootOf(listened.bound);
  SocketAddress relay = listened.endpoint.address;
  relay.scope_id = 0;
  return "/subscribe/" + relay.text();
}

}  // namespace

std::size_t FlowTable::Hash::operator()(const Flow& flow) const { return hashOf(flow); }
std::size_t FlowTable::Hash::operator()(const Key& key) const { return hashOf(key); }

FlowTable::FlowTable(std::vector<ListenedEndpoint> endpoints) {
  for (ListenedEndpoint& each : endpoints) {
    // A zone depends on the receiver, not on the group.
    each.bound.scope_id = 0;
    std::string root = rootOf(each);
    endpoints_.push_back({std::move(each), std::move(root), 0, {}});
  }
}

std::size_t FlowTable::channelOf(const Flow& flow) {
  if (const auto known = flows_.find(flow); known != flows_.end()) return known->second;
  EndpointState& endpoint = endpoints_[flow.endpoint];
  if (endpoint.flows == kFlowsAnEndpoint || flows_.size() == kFlows) return sharedChannel(flow);
  ++endpoint.flows;
  const std::size_t index = channels_.size();
  channels_.push_back(channelFor(flow, false));
  Key key{flow.endpoint,    flow.sender,  std::string(flow.source), flow.is_packet_text,
          flow.is_restated, std::nullopt, std::string(flow.subject)};
  if (flow.destination != nullptr) key.destination = *flow.destination;
  flows_.emplace(std::move(key), index);
  return index;
}

std::size_t FlowTable::sharedChannel(const Flow& flow) {
  const auto [place, is_new] = endpoints_[flow.endpoint].shared.try_emplace(
      {flow.is_packet_text, flow.is_restated}, channels_.size());
  if (is_new) channels_.push_back(channelFor(flow, true));
  return place->second;
}

FlowChannel FlowTable::channelFor(const Flow& flow, bool shared) const {
  const EndpointState& endpoint = endpoints_[flow.endpoint];
  FlowChannel channel;
  channel.endpoint = flow.endpoint;
  channel.encoding = flow.is_packet_text ? "rk1" : "octets";
  const std::string_view restated = flow.is_restated ? profile::kRestatedPrefix : "";
  if (endpoint.listened.endpoint.isNats()) {
    channel.metadata = {{"protocol", "nats"}, {"server", endpoint.listened.endpoint.nats.server()}};
    if (!flow.source.empty() && !shared) channel.metadata["source"] = flow.source;
    // A stranger chose it: bytes that a subject of ours never has would spoil the topic.
    const std::string subject = shared ? "_many" : plainText(flow.subject);
    channel.topic = fmt::format("{}{}/{}", restated, endpoint.root, subject);
    return channel;
  }
  channel.metadata = {{"protocol", "udp"}};
  // Without an address of its own, all flows beyond the limit share one channel, whatever their
  // destination.
  const Endpoint& listened = endpoint.listened.endpoint;
  std::optional<SocketAddress> local = endpoint.listened.bound;
  if (listened.isPcap()) local.reset();
  if (flow.destination != nullptr && !shared) local = *flow.destination;
  if (local) {
    channel.metadata["local"] = local->text();
    if (local->isMulticast()) channel.metadata["group"] = local->hostText();
  }
  const bool by_interface = listened.isPcap() || listened.isMulticast();
  if (by_interface && !listened.interface.empty()) {
    channel.metadata["interface"] = listened.interface;
  }
  if (shared) {
    channel.topic = fmt::format("{}{}/_many", restated, endpoint.root);
    return channel;
  }
  channel.metadata["remote"] = flow.sender.text();
  if (!flow.source.empty()) channel.metadata["source"] = flow.source;
  const std::string name = flow.source.empty() ? flow.sender.hostText() : encodeName(flow.source);
  const std::string root = flow.destination != nullptr ? rootOf(*flow.destination) : endpoint.root;
  channel.topic = fmt::format("{}{}/{}", restated, root, name);
  return channel;
}

}  // namespace rocinante
