#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/foreign/ros/device_finder.h"
#include "core/foreign/ros/ros_message.h"
#include "core/packet/packet.h"
#include "core/report/account.h"

namespace rocinante::ros {

/// Why messages were not translated, or not whole, by sentence: "NaN joint values" and how often.
using TranslationNotes = std::map<std::string, std::uint64_t, std::less<>>;

/// A message as packet text (docs/packet-format.md). Borrowed until the next message is translated.
struct Translated {
  std::string_view text;
  const Packet* packet = nullptr;  ///< what decoding `text` gives; null: not made, decode it
};

/// Turns ROS messages into packet text (docs/other-formats.md, "ROS"). One for a whole import:
/// frames and drawings are remembered from message to message. Messages must come in time order.
/// Not for sharing between threads.
class RosTranslator {
 public:
  /// `devices` must outlive this.
  explicit RosTranslator(const DeviceFinder& devices);
  ~RosTranslator();
  RosTranslator(const RosTranslator&) = delete;
  RosTranslator& operator=(const RosTranslator&) = delete;

  /// A topic of this type, "sensor_msgs/msg/Imu", whose messages are laid out so: its number for
  /// translate(). Empty for a type that is not translated. `metadata`: of its channel, which names
  /// what an export of ours wrote there (core/packet/channel_names.h).
  std::optional<std::size_t> addTopic(std::string_view topic, std::string_view type,
                                      FieldCursor::Layout layout,
                                      const std::map<std::string, std::string>& metadata = {});

  enum class Outcome : std::uint8_t {
    packet,
    nothing,    ///< there was nothing in it that a packet can say
    malformed,  ///< it does not fit its type
  };
  /// The message as a packet, in `out`, which is left alone otherwise.
  Outcome translate(std::size_t topic, LogTime time, ByteView message, Translated& out);

  TranslationNotes notes(std::size_t topic) const;
  /// The fields and transforms of all messages that no packet says.
  Account account() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rocinante::ros
