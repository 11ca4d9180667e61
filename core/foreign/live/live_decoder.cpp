#include "core/foreign/live/live_decoder.h"

#include <utility>

#include "core/foreign/decode/carried_decoders.h"

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

}  // namespace rocinante
