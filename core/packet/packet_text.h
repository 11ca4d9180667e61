#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/packet/decoder.h"

namespace rocinante {

/// Reads packet text version 1 (docs/packet-format.md).
class PacketTextDecoder final : public Decoder {
 public:
  PacketTextDecoder();
  ~PacketTextDecoder() override;

  std::string_view encoding() const override { return "rk1"; }
  const Packet* decode(ByteView datagram) override;
  std::span<const FaultAt> faults() const override;

  /// The header alone, cheaply: for recorders and relays, which need no statements. Null when the
  /// datagram is not a packet. Same validity as decode().
  const PacketHeader* decodeHeader(ByteView datagram);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

/// Builds the text of packets, one after the other in the same memory. Every append is canonical:
/// names percent-encoded, the shortest decimal that reads back as the same double, LF line ends.
/// Arguments must be values that a decoder can produce: names not empty and UTF-8, numbers finite,
/// as many as the kind requires.
class PacketTextWriter {
 public:
  PacketTextWriter() = default;
  explicit PacketTextWriter(const PacketHeader& header) { begin(header); }

  /// Begins the next packet; the text of the last one is gone.
  void begin(const PacketHeader& header);
  /// Appends one statement, written from the fields that its kind uses.
  void add(const Statement& statement);

  /// False before the first statement of a packet.
  bool hasStatements() const { return text_.size() > header_bytes_; }
  std::size_t byteCount() const { return text_.size(); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t header_bytes_ = 0;
};

/// The text of one header line or statement line, without its LF.
std::string headerText(const PacketHeader& header);
std::string statementText(const Statement& statement);

/// Whether a packet can say the name: 1 to 255 bytes of UTF-8 without control characters.
bool isName(std::string_view name);
/// `name` as a packet writes it: bytes outside A-Z a-z 0-9 _ . - : percent-encoded.
std::string encodeName(std::string_view name);
/// Whether a packet can say the unit: 1 to 32 printable ASCII characters but blanks and quotes.
bool isUnit(std::string_view unit);
/// For a text that is no unit: "did you mean `degC`?" of "°C", else what units look like.
std::string unitHint(std::string_view text);

}  // namespace rocinante
