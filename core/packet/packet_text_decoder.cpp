#include <span>

#include "core/packet/header_reader.h"
#include "core/packet/packet_text.h"
#include "core/packet/statement_reader.h"
#include "core/packet/text_lines.h"

namespace rocinante {
namespace {

constexpr std::string_view kEncoding = "rk1";
constexpr std::string_view kOtherEncoding = "octets";

/// True when only bytes follow that packet text ignores.
bool isLast(TextLines lines) {
  std::string_view line;
  return !lines.next(line);
}

bool isSignature(std::string_view line) { return TextFields(line).take() == "sig"; }

}  // namespace

struct PacketTextDecoder::Scratch {
  StatementScratch lines;
  StatementReader reader{lines};
  Packet packet;

  /// Takes the header line from `text`. False with one fault in `lines.faults`.
  bool readHeaderFrom(TextLines& text) {
    std::string_view line;
    if (!text.next(line) || !isHeaderLine(line)) {
      lines.faults.push_back({PacketFault::not_a_packet, 1, 1});
      return false;
    }
    std::uint32_t column = 1;
    if (readHeader(line, lines.arena, packet.header, column)) return true;
    lines.faults.push_back({PacketFault::bad_header, text.number(), column});
    return false;
  }
};

PacketTextDecoder::PacketTextDecoder() : scratch_(std::make_unique<Scratch>()) {}

PacketTextDecoder::~PacketTextDecoder() = default;

std::span<const FaultAt> PacketTextDecoder::faults() const { return scratch_->lines.faults; }

const PacketHeader* PacketTextDecoder::decodeHeader(ByteView datagram) {
  scratch_->lines.faults.clear();
  scratch_->lines.arena.begin(datagram.size());
  TextLines text(textOf(datagram));
  return scratch_->readHeaderFrom(text) ? &scratch_->packet.header : nullptr;
}

const Packet* PacketTextDecoder::decode(ByteView datagram) {
  scratch_->lines.begin(datagram.size());
  TextLines text(textOf(datagram));
  if (!scratch_->readHeaderFrom(text)) return nullptr;
  std::string_view line;
  while (text.next(line)) {
    if (isSignature(line) && isLast(text)) break;
    scratch_->reader.read(line, text.number());
  }
  scratch_->packet.statements = scratch_->lines.statements;
  scratch_->packet.faults = scratch_->lines.faults;
  return &scratch_->packet;
}

std::unique_ptr<Decoder> makeDecoder(std::string_view encoding) {
  if (encoding == kEncoding) return std::make_unique<PacketTextDecoder>();
  return nullptr;
}

std::string_view encodingOf(ByteView datagram) {
  TextLines text(textOf(datagram));
  std::string_view line;
  return text.next(line) && isHeaderLine(line) ? kEncoding : kOtherEncoding;
}

}  // namespace rocinante
