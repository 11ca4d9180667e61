#pragma once

#include <memory>
#include <vector>

#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "core/signing/trust_judge.h"

namespace rocinante {

/// Options shared by all programs that receive.
struct InputOptions {
  UdpReceiver::Options receiving;
  AddressFilter allow;  ///< other senders are dropped and counted as refused
  /// The addresses from which this program itself sends: datagrams from them are dropped.
  std::vector<SocketAddress> own;
  /// If set, datagrams that it refuses are dropped and counted, a relay's answers too. One judge
  /// for all inputs.
  std::shared_ptr<TrustJudge> trust;
  /// A stream (jetstream://) is read from where it was left: the caller confirms what it keeps.
  bool resuming = false;
};

/// Opens the endpoint: a receiving socket, a subscription at a relay (subscribe://), watched
/// traffic (pcap://), a subject (nats://) or a stream (jetstream://) of a server. Requests that are
/// for a relay are dropped and counted. Fails as UdpReceiver::open, openPcap, openNatsSource and
/// openJetStream do, a relay that does not answer is not a failure; bad_argument for `allow` with a
/// server, which does not tell who sends.
Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint,
                                                   const InputOptions& options);
inline Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint) {
  return openSource(endpoint, InputOptions());
}

/// Opens all of them, in this order, or returns the first failure. A capture file or a stream must
/// be the only endpoint (bad_argument): its times are not those of live traffic.
using Sources = std::vector<std::unique_ptr<DatagramSource>>;
Result<Sources> openSources(const std::vector<Endpoint>& endpoints, const InputOptions& options);

}  // namespace rocinante
