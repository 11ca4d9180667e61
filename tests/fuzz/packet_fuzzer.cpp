// Datagrams as an attacker would send them, separated by an empty line as in a keyframe: decoded,
// each statement written and read again, folded, and the state restated, which must give it back.
#include <cstdlib>
#include <string_view>

#include "core/packet/packet_text.h"
#include "core/packet/restatement.h"
#include "core/packet/session_state.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

void writeAndReadAgain(const Packet& packet) {
  PacketTextWriter writer(packet.header);
  for (const Statement& statement : packet.statements) writer.add(statement);
  PacketTextDecoder decoder;
  const Packet* const again = decoder.decode(bytesOf(writer.text()));
  require(again != nullptr && again->faults.empty());
  require(again->statements.size() == packet.statements.size());
  PacketTextWriter second(again->header);
  for (const Statement& statement : again->statements) second.add(statement);
  require(second.text() == writer.text());
}

void restateFromNothing(const SessionState& state, LogTime time) {
  RestatementOptions options;
  options.by = "keyframe";
  options.part_id = "k";
  options.with_seen = true;
  SessionState fresh;
  PacketTextDecoder decoder;
  for (const std::string& datagram : restateAll(state, options)) {
    const Packet* const packet = decoder.decode(bytesOf(datagram));
    require(packet != nullptr && packet->faults.empty());
    require(fresh.apply(time, *packet) == Applied::yes);
  }
  require(fresh.identityText() == state.identityText());
  require(fresh.sameAs(state) && fresh.weight() == state.weight());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  PacketTextDecoder decoder;
  SessionState state;
  LogTime time{};
  while (!rest.empty()) {
    const std::size_t end = rest.find("\n\n");
    const ByteView datagram = bytesOf(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
    time += std::chrono::milliseconds(300);
    const bool has_header = decoder.decodeHeader(datagram) != nullptr;
    const Packet* const packet = decoder.decode(datagram);
    require((packet != nullptr) == has_header);
    if (packet == nullptr) continue;
    writeAndReadAgain(*packet);
    state.apply(time, *packet);
  }
  restateFromNothing(state, time);
  return 0;
}
