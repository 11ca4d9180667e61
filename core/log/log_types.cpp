#include "core/log/log_types.h"

#include "core/log/log_profile.h"

namespace rocinante {
namespace {

bool isBelow(std::string_view topic, std::string_view prefix) {
  return topic.starts_with(prefix) && topic.substr(prefix.size()).starts_with('/');
}

}  // namespace

bool LogChannel::captured() const { return !topic.starts_with(profile::kOwnTopics); }

bool LogChannel::folded() const {
  if (captured()) return true;
  return isBelow(topic, profile::kRestatedPrefix) || decoded();
}

bool LogChannel::decoded() const { return isBelow(topic, profile::kDecodedPrefix); }

bool LogChannel::received() const {
  if (!folded() || decoded()) return false;
  // A piece may open with decoded packets from before it, restated.
  std::string_view restated = topic;
  if (!captured()) restated.remove_prefix(profile::kRestatedPrefix.size());
  return captured() || !isBelow(restated, profile::kDecodedPrefix);
}

bool LogChannel::imported() const { return metadata.contains(std::string(profile::kImportedKey)); }

LossCounts& LossCounts::operator+=(const LossCounts& other) {
  kernel += other.kernel;
  queue += other.queue;
  disk += other.disk;
  truncated += other.truncated;
  return *this;
}

}  // namespace rocinante
