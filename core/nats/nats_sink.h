#pragma once

#include <memory>

#include "core/net/datagram_sink.h"

namespace rocinante {

/// Publishes datagrams to a NATS server (nats://, docs/endpoints.md), each to the subject of its
/// SOURCE. While the server is away, up to 4 MiB wait for it; what comes beyond fails with refused.
/// Fails with bad_argument for a subject with wildcards or a jetstream://, refused when no server
/// answers or it refuses, also later when it does not let this client publish; unsupported when
/// the NATS module is missing.
Result<std::unique_ptr<DatagramSink>> openNatsSink(const Endpoint& to);

}  // namespace rocinante
