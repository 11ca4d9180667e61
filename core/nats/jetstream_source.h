#pragma once

#include <memory>

#include "core/net/datagram_source.h"

namespace rocinante {

enum class StreamReading {
  /// From `from`, or what is new: the server remembers nothing. For programs that only look.
  passing,
  /// From where the endpoint's durable stands, which confirm() moves; one reader at a time.
  resuming
};

/// Reads a stream that a NATS server keeps (jetstream://, docs/endpoints.md), each message once and
/// in the stream's order, with the stream's times as kernel_time. Messages that the server sent and
/// that did not arrive are fetched again; those that are gone from the stream (purged, deleted,
/// expired) are counted by dropped(). Reconnects as openNatsSource does. Fails with not_found when
/// there is no such stream; refused when no server answers, it refuses, or another reader has the
/// durable; unsupported when the NATS module is missing.
Result<std::unique_ptr<DatagramSource>> openJetStream(const Endpoint& endpoint,
                                                      StreamReading reading);

}  // namespace rocinante
