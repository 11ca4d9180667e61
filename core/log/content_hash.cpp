#include "core/log/content_hash.h"

#include "core/log/log_reader.h"

namespace rocinante {

void ContentHash::add(const LogMessage& message) {
  const std::string& topic = message.channel->topic;
  if (!message.channel->captured()) return;
  // The lengths keep the fields apart: no two sessions make the same bytes.
  hash_.addU64(topic.size());
  hash_.add(bytesOf(topic));
  hash_.addU64(static_cast<std::uint64_t>(message.log_time.time_since_epoch().count()));
  hash_.addU64(message.payload.size());
  hash_.add(message.payload);
}

std::string ContentHash::finish() { return hexOf(hash_.finish()); }

Result<std::string> contentSha256(LogReader& reader) {
  if (Status rewound = reader.rewind(); !rewound) return rewound.error();
  ContentHash hash;
  while (true) {
    Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    if (!*message) break;
    hash.add(**message);
  }
  if (Status rewound = reader.rewind(); !rewound) return rewound.error();
  return hash.finish();
}

}  // namespace rocinante
