#include "player/logs/restated_block.h"

#include "core/log/log_profile.h"
#include "core/packet/packet_text.h"
#include "core/packet/restatement.h"

namespace rocinante {

std::vector<RestatedDatagram> restatedBlock(const SessionState& state,
                                            const std::set<std::string>& sources,
                                            const PlayRoutes& routes, std::string_view part_id,
                                            std::size_t mtu_bytes) {
  RestatementOptions how;
  how.by = "player";
  how.reset = true;
  how.part_id = part_id;
  how.mtu_bytes = mtu_bytes;
  std::vector<std::string> texts = restateAll(state, how);
  for (const std::string& source : sources) {
    if (state.sources().contains(source) || profile::isDecodedSource(source)) continue;
    // Receivers must also forget a source that has not sent yet at this place.
    for (std::string& part : restate(state, source, how)) texts.push_back(std::move(part));
  }
  std::vector<RestatedDatagram> block;
  PacketTextDecoder decoder;
  for (std::string& text : texts) {
    const PacketHeader* header = decoder.decodeHeader(bytesOf(text));
    // Whoever listens gets the octets, and has a decoder or not.
    if (header != nullptr && profile::isDecodedSource(header->source)) continue;
    const std::vector<std::uint16_t>& ways =
        header == nullptr ? routes.restated_elsewhere : routes.restatedOf(header->source);
    for (std::size_t i = 1; i < ways.size(); ++i) block.push_back({text, ways[i]});
    if (!ways.empty()) block.push_back({std::move(text), ways[0]});
  }
  return block;
}

}  // namespace rocinante
