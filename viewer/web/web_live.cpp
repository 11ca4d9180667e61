#include "viewer/web/web_live.h"

#include <algorithm>

#include "viewer/web/live_message.h"

namespace rocinante {

Status WebLive::take(ByteView message) {
  const auto malformed = [] {
    return Error{ErrorKind::damaged, "the server sent an invalid live message", {}};
  };
  auto reader = LiveMessageReader::of(message);
  if (!reader) return malformed();
  if (reader->greets()) {
    state_ = SessionState();
    if (!greeted_) origin_ = reader->time();
    greeted_ = true;
  }
  // The fold's time does not go back.
  time_ = std::max(time_, reader->time());
  while (const auto bytes = reader->next()) {
    if (const Packet* const packet = decoder_.decode(*bytes)) state_.apply(time_, *packet);
  }
  state_.takeEvents();
  if (reader->isCut()) return malformed();
  return {};
}

}  // namespace rocinante
