#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/decode_account.h"
#include "core/packet/packet_text.h"
#include "core/recording/octet_decoder.h"

namespace rocinante {

/// Declared decoders (docs/decoders.md) at a recording: the packets are those that `log decode`
/// would make of the same octets in the log. One thread.
class LiveDecoder final : public OctetDecoder {
 public:
  explicit LiveDecoder(std::shared_ptr<const decode::DecoderSet> set);

  const MadePacket* decode(const FlowChannel& channel, std::int64_t publish_time_ns,
                           ByteView octets) override;

  const decode::DatagramDecoders& decoders() const { return decoders_; }
  /// Of everything that was given to decode().
  decode::DecodeAccount account() const { return decode::accountOf(decoders_, octets_); }

 private:
  decode::DatagramDecoders decoders_;
  std::vector<std::map<std::string, std::string>> metadata_;  ///< by decoder
  PacketTextDecoder packet_text_;
  MadePacket made_;
  std::uint64_t octets_ = 0;
};

}  // namespace rocinante
