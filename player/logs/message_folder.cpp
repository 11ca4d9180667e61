#include "player/logs/message_folder.h"

namespace rocinante {

MessageFolder::Folded MessageFolder::fold(SessionState& state, const LogMessage& message) {
  const std::string& encoding = message.channel->encoding;
  auto decoder = decoders_.find(encoding);
  if (decoder == decoders_.end()) {
    decoder = decoders_.emplace(encoding, makeDecoder(encoding)).first;
  }
  if (!decoder->second) return {};
  const Packet* packet = decoder->second->decode(message.payload);
  if (packet == nullptr) return {};
  const Folded folded{state.apply(message.log_time, *packet) == Applied::yes,
                      packet->header.part.has_value()};
  // Events would accumulate.
  state.takeEvents();
  return folded;
}

}  // namespace rocinante
