#pragma once

#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// What an MCAP file says about the messages of a channel.
struct MessageSchema {
  std::string name;      ///< "foxglove.Log", "sensor_msgs/msg/JointState"
  std::string encoding;  ///< of `data`: "protobuf", "ros2msg"
  Bytes data;
  std::string message_encoding;  ///< "protobuf", "cdr"
};

}  // namespace rocinante
