#include "core/relay/send_in_order.h"

namespace rocinante {

SendOutcome sendInOrder(DatagramSink& sink, std::span<const ByteView> payloads,
                        const std::function<bool()>& wait_for_room) {
  SendOutcome outcome;
  while (!payloads.empty()) {
    const Result<std::size_t> sent = sink.sendWithoutWaiting(payloads);
    if (sent && *sent == 0) {
      if (!wait_for_room()) break;
      continue;
    }
    if (!sent) {
      ++outcome.dropped;
      if (!outcome.trouble) outcome.trouble = sent.error();
    } else {
      outcome.sent += *sent;
    }
    payloads = payloads.subspan(sent ? *sent : 1);
  }
  outcome.dropped += payloads.size();
  return outcome;
}

}  // namespace rocinante
