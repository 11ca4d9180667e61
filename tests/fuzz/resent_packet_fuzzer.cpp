// A datagram as `source --log` sends it anew: its statement lines under a new header, in packets of
// a few sizes. Read again they are the same statements, in order and without a fault.
#include <cstdlib>
#include <string_view>

#include "core/packet/packet_text.h"
#include "player/source/resent_packet.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

bool isNotSent(const Statement& statement, const PacketHeader& header) {
  return statement.kind == StatementKind::seen ||
         (statement.kind == StatementKind::event && !header.by.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(text));
  if (packet == nullptr) return 0;
  std::string sent;
  for (const Statement& statement : packet->statements) {
    if (!isNotSent(statement, packet->header)) sent += statementText(statement) + '\n';
  }
  for (const std::size_t mtu_bytes : {64U, 512U, 65'507U}) {
    PacketHeader header;
    header.source = packet->header.source;
    header.sequence = 7;
    std::string read;
    std::uint64_t count = 0;
    for (const std::string& resent :
         packetsOf(header, statementLines(text, *packet, {}), mtu_bytes)) {
      PacketTextDecoder again;
      const Packet* const part = again.decode(bytesOf(resent));
      require(part != nullptr && part->header.sequence == 7 + count++);
      require(resent.size() <= mtu_bytes || part->statements.size() <= 1);
      for (const FaultAt& fault : part->faults) {
        require(fault.fault == PacketFault::unnormalised_quaternion);
      }
      for (const Statement& statement : part->statements) read += statementText(statement) + '\n';
    }
    require(read == sent);
    require(header.sequence == 7 + count);
  }
  return 0;
}
