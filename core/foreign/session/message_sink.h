#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// What an MCAP file says about the messages of a channel.
struct MessageSchema {
  std::string name;      ///< "foxglove.Log", "sensor_msgs/msg/JointState"
  std::string encoding;  ///< of `data`: "protobuf", "ros2msg"
  Bytes data;
  std::string message_encoding;  ///< "protobuf", "cdr"
};

/// Takes messages for other tools: a file of them, or whoever listens.
class MessageSink {
 public:
  virtual ~MessageSink() = default;

  /// The schema and `metadata` count when the topic is new.
  virtual Status write(std::string_view topic, const MessageSchema& schema, LogTime time,
                       ByteView message, const std::map<std::string, std::string>& metadata) = 0;
  Status write(std::string_view topic, const MessageSchema& schema, LogTime time,
               ByteView message) {
    return write(topic, schema, time, message, {});
  }
};

}  // namespace rocinante
