#include "core/foreign/live/received_decoder.h"

#include <utility>

#include "core/foreign/decode/carried_decoders.h"
#include "core/packet/decoder.h"

namespace rocinante {

LiveDecoder::LiveDecoder(std::shared_ptr<const decode::DecoderSet> set)
    : decoders_(std::move(set)) {
  for (std::size_t i = 0; i < decoders_.set().decoders.size(); ++i) {
    metadata_.push_back(decode::decodedMetadata(decoders_.set(), i));
  }
}

const MadePacket* LiveDecoder::decode(const FlowChannel& channel, std::int64_t publish_time_ns,
                                      ByteView octets) {
  ++octets_;
  const decode::Route route = decode::routeOf(channel.topic, channel.metadata);
  const decode::DecodedPacket* const packet = decoders_.decode(route, publish_time_ns, octets);
  if (packet == nullptr) return nullptr;
  made_.decoder = packet->decoder;
  made_.metadata = &metadata_[packet->decoder];
  made_.text = packet->text;
  made_.packet = packet_text_.decode(bytesOf(packet->text));
  return &made_;
}

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
