#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace rocinante {

using ChannelId = std::uint16_t;

/// The last moment that a log can hold. The one behind it stays free, so that the end of every
/// span, which is behind its last message, is representable too.
inline constexpr LogTime kLastLogTime = LogTime::max() - Nanoseconds(1);

/// What the messages of an imported channel mean, as the other program's file says it.
struct LogSchema {
  std::string name;      ///< "sensor_msgs/msg/JointState"
  std::string encoding;  ///< "ros2msg"
  Bytes data;
  auto operator<=>(const LogSchema&) const = default;
};

/// A one-way stream in a session: (listening endpoint, sender, SOURCE). docs/log-format.md.
struct LogChannel {
  ChannelId id = 0;
  std::string topic;
  std::string encoding;                         ///< "rk1", "octets"
  std::map<std::string, std::string> metadata;  ///< local remote protocol group interface source
  std::shared_ptr<const LogSchema> schema{};    ///< null: none, as on all channels of a recorder

  /// False for /rocinante/...: our own channels, excluded from counts, hashes and time ranges.
  bool captured() const;
  /// True for captured channels, for /rocinante/restated/... and for /rocinante/decoded/...: the
  /// fold reads these.
  bool folded() const;
  /// True for /rocinante/decoded/...: packets that a decoder made of another channel's messages.
  bool decoded() const;
  /// True for what was sent to the recorder: folded channels except what decoders made.
  bool received() const;
  /// True when the messages were translated from another format's recording.
  bool imported() const;
};

/// A position in a log's order: after every message that is earlier, or at the same time and before
/// it in the file.
struct LogPosition {
  LogTime time{};
  std::uint64_t file_offset = 0;  ///< LogMessage::file_offset
  auto operator<=>(const LogPosition&) const = default;
};

/// A datagram in a log. `payload` is borrowed: valid until the next message is read.
struct LogMessage {
  const LogChannel* channel = nullptr;
  std::uint32_t sequence = 0;  ///< the recorder's own count on the channel, modulo 2^32
  LogTime log_time{};
  std::int64_t publish_time_ns = 0;  ///< the sender's TIME; the log time when it gave none
  /// Its position in the file's order, which breaks ties of log_time: the chunk's number in the
  /// file in the upper 32 bits, the offset of the record in the expanded chunk in the lower.
  std::uint64_t file_offset = 0;
  ByteView payload;

  LogPosition place() const { return {log_time, file_offset}; }
};

/// Why the log holds fewer datagrams than were sent to it, per listening endpoint.
struct LossCounts {
  std::uint64_t kernel = 0;     ///< the socket's buffer was full
  std::uint64_t queue = 0;      ///< the recorder's own queue was full
  std::uint64_t disk = 0;       ///< the disk refused the write
  std::uint64_t truncated = 0;  ///< kept, but cut: larger than the receive buffer

  LossCounts& operator+=(const LossCounts& other);
  bool operator==(const LossCounts&) const = default;
};

/// Losses of one endpoint between two log times: a message on /rocinante/loss.
struct LossSpan {
  std::string endpoint;
  LogTime from{}, until{};
  LossCounts counts;
};

/// A damaged part of the file: bytes [from, to) could not be used, and the cost.
struct DamageSpan {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::string cause;
  std::optional<std::uint64_t> messages_lost;  ///< empty when it cannot be known
  bool out_of_order = false;                   ///< messages there are read, but out of time order
};

struct LogAttachment {
  std::string name;
  std::string media_type;
  LogTime log_time{};
  std::uint64_t data_bytes = 0;
};

struct LogMetadata {
  std::string name;
  std::map<std::string, std::string> entries;
};

}  // namespace rocinante
