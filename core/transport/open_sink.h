#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/net/datagram_sink.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Opens where datagrams are sent to. Fails as UdpSender::open and openNatsSink do; bad_argument
/// for an endpoint that is only read (pcap://).
Result<std::unique_ptr<DatagramSink>> openSink(const Endpoint& to);

}  // namespace rocinante
