#include "core/session/message_folder.h"

namespace rocinante {

Applied foldPacket(SessionState& state, LogTime time, const Packet& packet,
                   std::vector<Event>* events) {
  const Applied applied = state.apply(time, packet);
  std::vector<Event> taken = state.takeEvents();
  if (events != nullptr) {
    events->insert(events->end(), std::make_move_iterator(taken.begin()),
                   std::make_move_iterator(taken.end()));
  }
  return applied;
}

Decoder* MessageFolder::decoderOf(const LogChannel& channel) {
  if (!channel.folded()) return nullptr;
  auto found = decoders_.find(channel.encoding);
  if (found == decoders_.end()) {
    found = decoders_.emplace(channel.encoding, makeDecoder(channel.encoding)).first;
  }
  return found->second.get();
}

const Packet* MessageFolder::decode(const LogMessage& message) {
  Decoder* const decoder = decoderOf(*message.channel);
  return decoder == nullptr ? nullptr : decoder->decode(message.payload);
}

MessageFolder::Folded MessageFolder::fold(SessionState& state, const LogMessage& message,
                                          std::vector<Event>* events) {
  const Packet* const packet = decode(message);
  if (packet == nullptr) return {};
  return {packet, foldPacket(state, message.log_time, *packet, events) == Applied::yes};
}

}  // namespace rocinante
