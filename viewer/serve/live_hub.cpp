#include "viewer/serve/live_hub.h"

#include <utility>

#include "core/packet/restatement.h"
#include "viewer/web/live_message.h"

namespace rocinante {
namespace {

/// A greeting is cut into messages of about this size, so that none holds up a connection.
constexpr std::size_t kGreetingBytes = 64 * 1024;

Relay::Options relayOptions(LiveHub::Options& options) {
  Relay::Options relay;
  relay.name = options.name;
  relay.run = options.run;
  relay.applied = std::move(options.applied);
  return relay;
}

}  // namespace

LiveHub::LiveHub(Options options, LogTime now)
    : name_(options.name), relay_(relayOptions(options)) {
  RelayOutputOptions stream;
  stream.pacing.interval = Nanoseconds(static_cast<std::int64_t>(1e9 / options.rate_hz));
  relay_.open(std::move(stream), now);
}

SharedMessage LiveHub::takeMessage(LogTime now) {
  if (relay_.outgoing().empty()) return {};
  Bytes bytes = SharedMessage::begin();
  beginLiveMessage(bytes, false, now);
  for (const Relay::Outgoing& each : relay_.outgoing()) appendLivePacket(bytes, each.payload);
  relay_.clearOutgoing();
  return SharedMessage(std::move(bytes));
}

std::vector<SharedMessage> LiveHub::greeting(LogTime now) const {
  RestatementOptions how;
  how.by = name_;
  how.part_id = "greeting";
  std::vector<SharedMessage> messages;
  Bytes bytes = SharedMessage::begin();
  beginLiveMessage(bytes, true, now);
  for (const std::string& packet : restateAll(relay_.state(), how)) {
    if (bytes.size() + packet.size() > kGreetingBytes) {
      messages.emplace_back(std::exchange(bytes, SharedMessage::begin()));
      beginLiveMessage(bytes, false, now);
    }
    appendLivePacket(bytes, bytesOf(packet));
  }
  messages.emplace_back(std::move(bytes));
  return messages;
}

}  // namespace rocinante
