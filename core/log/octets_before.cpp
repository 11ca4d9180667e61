#include "core/log/octets_before.h"

#include "core/log/log_profile.h"

namespace rocinante {

bool OctetsBefore::areOf(const LogMessage& packet) const {
  return any_ && packet.channel->decoded() && packet.log_time == log_time_ &&
         packet.sequence == sequence_ && packet.publish_time_ns == publish_time_ns_ &&
         std::string_view(packet.channel->topic).substr(profile::kDecodedPrefix.size()) == topic_;
}

bool OctetsBefore::take(const LogMessage& message) {
  const bool fits = !message.channel->decoded() || areOf(message);
  any_ = message.channel->captured();
  if (!any_) return fits;
  topic_ = message.channel->topic;
  log_time_ = message.log_time;
  publish_time_ns_ = message.publish_time_ns;
  sequence_ = message.sequence;
  return fits;
}

}  // namespace rocinante
