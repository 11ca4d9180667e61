#include "core/transport/open_sink.h"

#include <utility>

#include "core/nats/nats_sink.h"
#include "core/net/udp_socket.h"

namespace rocinante {

Result<std::unique_ptr<DatagramSink>> openSink(const Endpoint& to) {
  if (to.isNats()) return openNatsSink(to);
  Result<UdpSender> sender = UdpSender::open(to);
  if (!sender) return sender.error();
  return std::make_unique<UdpSender>(std::move(*sender));
}

}  // namespace rocinante
