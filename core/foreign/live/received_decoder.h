#pragma once

#include <memory>
#include <vector>

#include "core/base/time.h"
#include "core/foreign/live/live_decoder.h"
#include "core/net/datagram_source.h"

namespace rocinante {

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
