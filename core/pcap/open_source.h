#pragma once

#include <memory>
#include <vector>

#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"

namespace rocinante {

/// Options shared by all programs that receive.
struct InputOptions {
  UdpReceiver::Options receiving;
  AddressFilter allow;  ///< other senders are dropped and counted as refused
  /// The addresses from which this program itself sends: datagrams from them are dropped.
  std::vector<SocketAddress> own;
};

/// Opens the endpoint: a receiving socket, or watched traffic (pcap://). Fails as UdpReceiver::open
/// and openPcap do.
Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint,
                                                   const InputOptions& options);
inline Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint) {
  return openSource(endpoint, InputOptions());
}

/// Opens all of them, in this order, or returns the first failure. A capture file must be the only
/// endpoint (bad_argument): its times are not those of live traffic.
using Sources = std::vector<std::unique_ptr<DatagramSource>>;
Result<Sources> openSources(const std::vector<Endpoint>& endpoints, const InputOptions& options);

}  // namespace rocinante
