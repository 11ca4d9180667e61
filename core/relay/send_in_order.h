#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "core/net/datagram_sink.h"

namespace rocinante {

/// What became of the datagrams of one step.
struct SendOutcome {
  std::uint64_t sent = 0;
  std::uint64_t dropped = 0;     ///< no room in time, or refused by the system
  std::optional<Error> trouble;  ///< the first refusal
};

/// Sends the datagrams in order, without blocking in the system: where there is no room it calls
/// `wait_for_room`, which returns false when the rest is to be dropped. A datagram that the system
/// refuses is dropped alone. The step that `record --tee` and a relay's `--to` share.
SendOutcome sendInOrder(DatagramSink& sink, std::span<const ByteView> payloads,
                        const std::function<bool()>& wait_for_room);

}  // namespace rocinante
