#include "core/log/log_types.h"

#include "core/log/log_profile.h"

namespace rocinante {

bool LogChannel::captured() const { return !topic.starts_with(profile::kOwnTopics); }

bool LogChannel::folded() const {
  if (captured()) return true;
  const std::string_view prefix = profile::kRestatedPrefix;
  return topic.size() > prefix.size() && topic.starts_with(prefix) && topic[prefix.size()] == '/';
}

LossCounts& LossCounts::operator+=(const LossCounts& other) {
  kernel += other.kernel;
  queue += other.queue;
  disk += other.disk;
  truncated += other.truncated;
  return *this;
}

}  // namespace rocinante
