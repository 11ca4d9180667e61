#pragma once

#include <memory>
#include <vector>

#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"

namespace rocinante {

/// How everything that listens listens.
struct InputOptions {
  UdpReceiver::Options receiving;
  AddressFilter allow;  ///< from elsewhere nothing is given; counted as refused
  /// The addresses from which this program itself sends what it heard: never heard again.
  std::vector<SocketAddress> own;
};

/// What the endpoint names: a socket that listens, or traffic that is watched (pcap://). Fails as
/// UdpReceiver::open and PcapSource::open do.
Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint,
                                                   const InputOptions& options);
inline Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint) {
  return openSource(endpoint, InputOptions());
}

/// All of them, in this order, or the first failure. A capture file stands alone (bad_argument):
/// its times are not those of what arrives now.
using Sources = std::vector<std::unique_ptr<DatagramSource>>;
Result<Sources> openSources(const std::vector<Endpoint>& endpoints, const InputOptions& options);

}  // namespace rocinante
