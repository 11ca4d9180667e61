#pragma once

#include <cstddef>
#include <memory>

#include "core/net/datagram_source.h"

namespace rocinante {

struct NatsSourceOptions {
  /// For messages that wait to be received; further ones are dropped and counted. Each takes its
  /// payload and 512 bytes.
  std::size_t buffer_bytes = std::size_t{32} << 20U;
};

/// Subscribes to a subject of a NATS server (nats://, docs/endpoints.md). Each message is a
/// datagram, stamped with the wall clock when it arrives, and may be as long as the server allows.
/// The library's threads receive, and connect again for as long as it takes: maintain()
/// says when the connection is lost and when it has returned. dropped() counts messages for which
/// the buffer had no room; what was published while there was no connection is in no count of ours,
/// only a gap in its source's numbers. After the server has turned this client away, receive()
/// fails. Fails with refused when no server answers or it refuses; unsupported when the NATS
/// module is missing.
Result<std::unique_ptr<DatagramSource>> openNatsSource(const Endpoint& endpoint,
                                                       const NatsSourceOptions& options);

}  // namespace rocinante
