#include "player/played_span.h"

#include <map>
#include <memory>

#include "core/packet/decoder.h"

namespace rocinante {

Result<StateBefore> stateBefore(LogMerge& logs, LogTime moment) {
  StateBefore before;
  std::map<std::string, std::unique_ptr<Decoder>, std::less<>> decoders;
  if (const Status found = logs.seek(LogTime::min(), LogMerge::Which::folded); !found) {
    return found.error();
  }
  while (true) {
    const Result<std::optional<LogMessage>> message = logs.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time >= moment) break;
    const std::string& encoding = (*message)->channel->encoding;
    auto decoder = decoders.find(encoding);
    if (decoder == decoders.end()) {
      decoder = decoders.emplace(encoding, makeDecoder(encoding)).first;
    }
    if (!decoder->second) continue;
    const Packet* packet = decoder->second->decode((*message)->payload);
    if (packet != nullptr) before.state.apply((*message)->log_time, *packet);
  }
  // Events were played when they happened; a restatement never says one again.
  before.state.takeEvents();
  before.silent_sources = logs.sources();
  for (const auto& [source, memory] : before.state.sources()) before.silent_sources.erase(source);
  return before;
}

}  // namespace rocinante
