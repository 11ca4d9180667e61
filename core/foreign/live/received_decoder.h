#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/decode_account.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/net/datagram_source.h"
#include "core/packet/packet_text.h"
#include "core/recording/octet_decoder.h"

namespace rocinante {

/// The decoders of a live edge: those of `file` (--decoders), else those that the cell names; null
/// when there are neither.
inline Result<std::shared_ptr<const decode::DecoderSet>> decodersFor(const std::string& file,
                                                                     const Cell& cell) {
  if (!file.empty()) return decode::readDecoders(file);
  if (cell.decoders.empty()) return std::shared_ptr<const decode::DecoderSet>();
  auto set = decode::readDecoders(cell.decoders);
  if (set) return set;
  // A cell from a log lies in a folder that users do not know.
  Error error = set.error();
  error.what = cell.shown(std::move(error.what));
  error.where = cell.shown(std::move(error.where));
  return error;
}

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

/// Declared decoders at an edge that receives and does not record: finds the channel that each
/// datagram would have in a log, by which a declaration may choose. One thread.
class ReceivedDecoder {
 public:
  ReceivedDecoder(std::shared_ptr<const decode::DecoderSet> set,
                  std::vector<ListenedEndpoint> endpoints);

  /// The packet made of a datagram of this endpoint; null for packet text and for what no decoder
  /// understands. Borrowed until the next call. `time` becomes TIME.
  const MadePacket* decode(std::size_t endpoint, const ReceivedDatagram& datagram, LogTime time);

  /// The channel of a datagram that is not packet text.
  const FlowChannel& channelOf(std::size_t endpoint, const ReceivedDatagram& datagram);
  const LiveDecoder& decoder() const { return decoder_; }

 private:
  LiveDecoder decoder_;
  FlowTable flows_;
};

/// The endpoints of open sources, with the ports that were bound.
template <class Sources>
std::vector<ListenedEndpoint> listenedEndpoints(const Sources& sources) {
  std::vector<ListenedEndpoint> listened;
  for (const auto& each : sources) listened.push_back({each->endpoint(), each->boundAddress()});
  return listened;
}

}  // namespace rocinante
