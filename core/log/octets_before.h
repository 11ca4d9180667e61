#pragma once

#include <string>

#include "core/log/log_types.h"

namespace rocinante {

/// Tells whether a decoded packet directly follows the octets that it was made of
/// (docs/log-format.md, "Decoded packets"). Give it every message in the order of the file.
class OctetsBefore {
 public:
  /// False for a message on /rocinante/decoded/TOPIC that does not directly follow a message on
  /// TOPIC with its log_time, publish_time and sequence; true for every other message.
  bool take(const LogMessage& message);

  /// True when `packet` was made of the message taken last.
  bool areOf(const LogMessage& packet) const;

 private:
  bool any_ = false;  ///< the last message was captured
  std::string topic_;
  LogTime log_time_{};
  std::int64_t publish_time_ns_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace rocinante
