#pragma once

#include <memory>

#include "core/log/log_writer.h"
#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Where keyframes stand: docs/log-format.md, "Keyframes".
struct KeyframeOptions {
  /// When false nothing is folded either, and no keyframe is written but by beginWith().
  bool enabled = true;
  std::uint64_t packets = 20'000;  ///< folded packets after which one is due
  Nanoseconds span{
      std::chrono::seconds(10)};  ///< log time after which one is due, if anything came
};

/// Writes a session: a LogWriter with the fold beside it, so that keyframes stand in the log where
/// docs/log-format.md, "Keyframes", wants them. What a recorder and every tool that drops, adds or
/// merges messages write through. Messages come in time order: after a folded one that goes back
/// there are no more keyframes. Not for sharing between threads; starts none, reads no clock.
class SessionWriter {
 public:
  SessionWriter(LogWriter log, const KeyframeOptions& options);
  ~SessionWriter();
  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;

  /// Begins in the middle of a session: `preceding` is what was folded before the first message,
  /// and is written as a keyframe at `moment`, not later than that message (none when it is empty).
  /// Before any message, at most once: bad_argument. A restatement that is unfinished in
  /// `preceding` is abandoned: a log says nothing of it.
  Status beginWith(const SessionState& preceding, LogTime moment);

  /// As LogWriter's; refused for the topic of keyframes.
  Result<ChannelId> addChannel(std::string topic, std::string encoding,
                               std::map<std::string, std::string> metadata);
  /// As LogWriter's. A captured or restated message that a decoder knows is folded too; a keyframe
  /// that is due goes before it. Keyframes are made, not copied.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload);
  /// The same for who has decoded the payload already: `packet` is what the decoder of the
  /// channel's encoding made of it, null when it is no packet.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload, const Packet* packet);
  /// An event that a person put there: a message on /rocinante/mark, not folded.
  Status writeMark(LogTime time, std::string_view text);

  /// The fold of all that was written (with what preceded), in the order of writing.
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
