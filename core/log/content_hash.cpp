#include "core/log/content_hash.h"

#include <utility>

#include "core/log/log_reader.h"

namespace rocinante {

namespace {

/// The lengths separate the fields: no two sessions give the same bytes.
void addTo(Sha256& hash, const LogMessage& message) {
  const std::string& topic = message.channel->topic;
  hash.addU64(topic.size());
  hash.add(bytesOf(topic));
  hash.addU64(static_cast<std::uint64_t>(message.log_time.time_since_epoch().count()));
  hash.addU64(message.payload.size());
  hash.add(message.payload);
}

}  // namespace

void ContentHash::add(const LogMessage& message) {
  if (message.channel->captured()) return addTo(captured_, message);
  if (!message.channel->decoded()) return;
  any_decoded_ = true;
  addTo(decoded_, message);
}

std::string ContentHash::finish() { return hexOf(captured_.finish()); }

std::string ContentHash::finishDecoded() {
  const std::string hash = hexOf(decoded_.finish());
  return std::exchange(any_decoded_, false) ? hash : std::string();
}

Result<SessionHashes> sessionHashes(LogReader& reader) {
  if (Status rewound = reader.rewind(); !rewound) return rewound.error();
  ContentHash hash;
  while (true) {
    Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    if (!*message) break;
    hash.add(**message);
  }
  if (Status rewound = reader.rewind(); !rewound) return rewound.error();
  return SessionHashes{hash.finish(), hash.finishDecoded()};
}

Result<std::string> contentSha256(LogReader& reader) {
  Result<SessionHashes> hashes = sessionHashes(reader);
  if (!hashes) return hashes.error();
  return std::move(hashes->content);
}

}  // namespace rocinante
