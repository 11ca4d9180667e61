#include "core/foreign/live/received_decoder.h"

#include <utility>

#include "core/packet/decoder.h"

namespace rocinante {

ReceivedDecoder::ReceivedDecoder(std::shared_ptr<const decode::DecoderSet> set,
                                 std::vector<ListenedEndpoint> endpoints)
    : decoder_(std::move(set)), flows_(std::move(endpoints)) {}

const FlowChannel& ReceivedDecoder::channelOf(std::size_t endpoint,
                                              const ReceivedDatagram& datagram) {
  Flow flow{static_cast<std::uint32_t>(endpoint), datagram.sender, {}, false, false};
  flow.destination = datagram.destination;
  flow.subject = datagram.subject;
  return flows_.channels()[flows_.channelOf(flow)];
}

const MadePacket* ReceivedDecoder::decode(std::size_t endpoint, const ReceivedDatagram& datagram,
                                          LogTime time) {
  if (encodingOf(datagram.payload) == "rk1") return nullptr;
  return decoder_.decode(channelOf(endpoint, datagram), time.time_since_epoch().count(),
                         datagram.payload);
}

}  // namespace rocinante
