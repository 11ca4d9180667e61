#pragma once

#include <memory>

#include "core/log/log_writer.h"
#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// When keyframes are written: docs/log-format.md, "Keyframes".
struct KeyframeOptions {
  /// When false, messages are not folded either, and only beginWith() writes a keyframe.
  bool enabled = true;
  std::uint64_t packets = 20'000;  ///< folded packets after which one is due
  Nanoseconds span{
      std::chrono::seconds(10)};  ///< log time after which one is due, if anything was written
};

/// Writes a session: a LogWriter plus the fold, so that the log gets keyframes as in
/// docs/log-format.md, "Keyframes". Used by the recorder and by every tool that drops, adds or
/// merges messages. Messages must come in time order: after a folded one that goes back there are
/// no more keyframes. Not for sharing between threads; starts none, reads no clock.
class SessionWriter {
 public:
  SessionWriter(LogWriter log, const KeyframeOptions& options);
  ~SessionWriter();
  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;

  /// Begins in the middle of a session: `preceding` is the fold before the first message, and is
  /// written as a keyframe at `moment`, which is not later than that message (none when it is
  /// empty). Call it before any message, at most once: otherwise bad_argument. An unfinished
  /// restatement in `preceding` is abandoned, because a keyframe cannot express it.
  Status beginWith(const SessionState& preceding, LogTime moment);

  /// As LogWriter's; refused for the topic of keyframes.
  Result<ChannelId> addChannel(std::string topic, std::string encoding,
                               std::map<std::string, std::string> metadata,
                               std::shared_ptr<const LogSchema> schema = nullptr);
  /// As LogWriter's. A captured, restated or decoded message that holds a packet is folded too; a
  /// due keyframe is written before it, but never between octets and the packet decoded from them.
  /// Keyframes are made here, not copied.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload);
  /// The same for a payload that is already decoded: `packet` is the result of the channel's
  /// decoder, null when the payload is not a packet.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload, const Packet* packet);
  /// An event set by a person: a message on /rocinante/mark, not folded.
  Status writeMark(LogTime time, std::string_view text);

  /// The fold of everything written (and the preceding state), in the order of writing.
  const SessionState& state() const;
  std::uint64_t keyframes() const;

  /// For everything else: losses, attachments, metadata, origin, flushing, closing.
  LogWriter& log();
  const LogWriter& log() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
