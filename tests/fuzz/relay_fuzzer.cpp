// Datagrams as a relay hears them, separated by an empty line, with a whole, a filtered, a rated
// and a slow output. Everything that it sends is packet text with this relay's name in it or a copy
// of what came; listeners that lose nothing find nothing late, and have the relay's items at the
// end.
#include <cstdlib>
#include <map>
#include <string_view>

#include "core/relay/relay.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Listener {
  SessionState state;
  PacketTextDecoder decoder;
};

void deliver(Relay& relay, std::map<Relay::OutputId, Listener>& listeners, LogTime now) {
  for (const Relay::Outgoing& each : relay.outgoing()) {
    for (auto& [id, listener] : listeners) {
      const bool is_whole = each.output == Relay::kEveryWhole && relay.isWhole(id);
      if (each.output != id && !is_whole) continue;
      const Packet* const packet = listener.decoder.decode(each.payload);
      require(packet != nullptr && packet->header.via.has_value() >= !relay.isWhole(id));
      listener.state.apply(now, *packet);
    }
  }
  relay.clearOutgoing();
}

std::size_t itemsOf(const SessionState& state) {
  std::size_t items = 0;
  forEachItem(state, [&](ItemKey&&) { ++items; });
  return items;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  Relay relay({"site", "r", std::chrono::seconds(1)});
  LogTime now(std::chrono::seconds(10));
  RelayOutputOptions filtered, rated, slow;
  filtered.filters.push_back({{}, {"a*"}, ~0U, {"a* [!b]*"}});
  rated.pacing.interval = std::chrono::milliseconds(70);
  rated.pacing.min_change = {0.1, 0.1, 0.1, {{"*", 0.1}}};
  slow.bytes_per_second = 3600;
  std::map<Relay::OutputId, Listener> listeners;
  const Relay::OutputId whole = relay.open({}, now);
  const Relay::OutputId at_rate = relay.open(rated, now);
  for (const auto id : {whole, at_rate, relay.open(filtered, now), relay.open(slow, now)}) {
    listeners[id];
  }
  int datagrams = 0;
  while (!rest.empty()) {
    const std::size_t end = rest.find("\n\n");
    const ByteView datagram = bytesOf(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
    now += std::chrono::milliseconds(30);
    relay.receive(datagram, now);
    deliver(relay, listeners, now);
    if (++datagrams % 5 == 0) relay.greet(whole);
    relay.advance(now);
    deliver(relay, listeners, now);
  }
  for (int i = 0; i < 400; ++i) {
    now += std::chrono::milliseconds(10);
    relay.advance(now);
    deliver(relay, listeners, now);
  }
  require(itemsOf(listeners[at_rate].state) == itemsOf(relay.state()));
  return 0;
}
