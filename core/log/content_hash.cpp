#include "core/log/content_hash.h"

namespace rocinante {

void ContentHash::add(const LogMessage& message) {
  const std::string& topic = message.channel->topic;
  if (!message.channel->captured()) return;
  // The lengths separate the fields: no two sessions give the same bytes.
  hash_.addU64(topic.size());
  hash_.add(bytesOf(topic));
  hash_.addU64(static_cast<std::uint64_t>(message.log_time.time_since_epoch().count()));
  hash_.addU64(message.payload.size());
  hash_.add(message.payload);
}

std::string ContentHash::finish() { return hexOf(hash_.finish()); }

}  // namespace rocinante
