#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/foreign/decode/field_reader.h"
#include "core/foreign/decode/packet_lines.h"
#include "core/packet/packet_text.h"
#include "core/report/account.h"

namespace rocinante::decode {

/// Where a datagram came from and went to.
struct Route {
  std::uint16_t port = 0;   ///< local; 0: unknown
  std::string_view sender;  ///< ADDRESS:PORT, [ADDRESS]:PORT for IPv6; empty: unknown
  std::string_view topic;   ///< of its channel in a log; empty while none is known
};

/// What became of the datagrams that a decoder's match fits.
struct DecodeCounts {
  std::uint64_t decoded = 0;
  std::uint64_t refused = 0;       ///< not of the declared form, or their packet is too long
  std::uint64_t empty = 0;         ///< no line applied: its fields were missing
  std::string_view last_reason{};  ///< of the last one refused
};

/// A packet made of a datagram. Borrowed until the next decode().
struct DecodedPacket {
  std::size_t decoder = 0;  ///< index in DecoderSet::decoders
  std::string_view source;  ///< "decoded:NAME"
  std::string_view text;
};

/// Most bytes of a packet: those of an IPv4 datagram, so that it can be sent on.
inline constexpr std::size_t kMaxPacketBytes = 65'507;

/// Makes packets of datagrams by a set of decoders: the first decoder whose match fits and whose
/// lines apply. Bounded memory whatever arrives. One per thread; reads no clock.
class DatagramDecoders {
 public:
  explicit DatagramDecoders(std::shared_ptr<const DecoderSet> set);
  /// The decoders of a file, as readDecoders().
  static Result<DatagramDecoders> open(const std::filesystem::path& file);

  /// Null when no decoder makes a packet of it. `publish_time_ns` becomes TIME. Packet text is
  /// never decoded: give it only what is none.
  const DecodedPacket* decode(const Route& route, std::int64_t publish_time_ns, ByteView payload);

  /// Of the datagram that was given to decode() last, by all decoders that read it, whether one of
  /// them made a packet or not. Borrowed until the next decode().
  std::span<const NotFiniteField> notFinite() const { return not_finite_; }

  const DecoderSet& set() const { return *set_; }
  /// By decoder.
  const std::vector<DecodeCounts>& counts() const { return counts_; }
  /// Values of fields that lines could not use, and those that no name of an enumeration fits;
  /// lengths of quaternions that are not 1.
  Account leftOut() const;
  /// See FieldReader::undeclared(), for the decoder that would read the datagram; empty for none.
  std::vector<FoundField> undeclared(const Route& route, ByteView payload, std::size_t most);
  /// Whether the datagram passes `match`, ignoring `where`.
  bool fits(std::size_t decoder, const Route& route, ByteView payload) const {
    return fits(set_->decoders[decoder].match, route, payload);
  }

 private:
  struct Reader {
    std::unique_ptr<FieldReader> fields;
    PacketLines lines;
    std::vector<FieldValue> values;
    std::string source;
    /// By sender and topic: valueText() of each event's field in the last datagram.
    std::map<std::string, std::vector<std::string>, std::less<>> before;
  };

  bool fits(const Match& match, const Route& route, ByteView payload) const;
  bool decodeBy(std::size_t index, const Route& route, std::int64_t publish_time_ns,
                ByteView payload);

  std::shared_ptr<const DecoderSet> set_;
  std::vector<Reader> readers_;
  std::vector<DecodeCounts> counts_;
  DecodedPacket packet_;
  std::vector<NotFiniteField> not_finite_;
  PacketTextWriter writer_;
  std::string key_;
};

}  // namespace rocinante::decode
