#include "player/source/resent_packet.h"

#include "core/packet/item_text.h"
#include "core/packet/packet_text.h"
#include "core/packet/text_lines.h"

namespace rocinante {
namespace {

bool isSent(const Statement& statement, const PacketHeader& header,
            const std::vector<std::string>& devices) {
  if (statement.kind == StatementKind::seen) return false;
  if (statement.kind == StatementKind::event) return header.by.empty();
  return devices.empty() || statement.kind == StatementKind::erase ||
         isAboutDevice(statement, devices);
}

}  // namespace

std::vector<std::string_view> statementLines(std::string_view text, const Packet& packet,
                                             const std::vector<std::string>& devices) {
  std::vector<std::string_view> found;
  TextLines lines(text);
  std::string_view line;
  for (const Statement& statement : packet.statements) {
    if (!isSent(statement, packet.header, devices)) continue;
    while (lines.number() < statement.line && lines.next(line)) {
    }
    found.push_back(line);
  }
  return found;
}

std::vector<std::string> packetsOf(PacketHeader& header, const std::vector<std::string_view>& lines,
                                   std::size_t mtu_bytes) {
  std::vector<std::string> packets;
  bool is_empty = true;
  const auto begin = [&] {
    packets.push_back(headerText(header) + '\n');
    if (header.sequence) ++*header.sequence;
    is_empty = true;
  };
  begin();
  for (const std::string_view line : lines) {
    if (!is_empty && packets.back().size() + line.size() + 1 > mtu_bytes) begin();
    packets.back().append(line) += '\n';
    is_empty = false;
  }
  return packets;
}

}  // namespace rocinante
