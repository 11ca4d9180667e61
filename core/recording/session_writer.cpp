#include "core/recording/session_writer.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/log/log_profile.h"
#include "core/session/keyframe.h"
#include "core/session/marks.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

constexpr LogTime kBeforeAll{Nanoseconds(std::numeric_limits<std::int64_t>::min())};

/// Keyframes are at most 1/kKeyframeShare of the stored payload: docs/log-format.md, "Keyframes".
constexpr std::uint64_t kKeyframeShare = 4;

}  // namespace

struct SessionWriter::Impl {
  Impl(LogWriter log_writer, const KeyframeOptions& given)
      : log(std::move(log_writer)), options(given), makes_keyframes(given.enabled) {}

  LogWriter log;
  KeyframeOptions options;

  SessionState state;
  MessageFolder folder;
  std::vector<Decoder*> decoder_by_channel;  ///< null: not folded, or without keyframes
  std::vector<bool> is_decoded;  ///< by channel: its messages directly follow their octets

  bool begun = false;  ///< a message or the preceding state was written
  bool makes_keyframes;
  std::optional<ChannelId> keyframe_channel;
  std::uint32_t keyframe_count = 0;
  std::optional<ChannelId> mark_channel;
  std::uint32_t mark_count = 0;

  LogTime last_time = kBeforeAll;      ///< the latest of any message
  LogTime folded_time = kBeforeAll;    ///< the latest of a folded one
  bool went_back = false;              ///< a message earlier than `last_time` was written
  LogTime keyframe_time = kBeforeAll;  ///< of the last keyframe, or of the first message
  std::uint64_t packets_since = 0;     ///< folded since then
  std::uint64_t message_bytes = 0;     ///< payloads except keyframes
  std::uint64_t keyframe_bytes = 0;    ///< payloads of keyframes that were due
  std::uint64_t expected_bytes = 0;    ///< of the next one, by the size of the last one made

  Decoder* decoderOf(ChannelId channel) const {
    return channel < decoder_by_channel.size() ? decoder_by_channel[channel] : nullptr;
  }

  bool followsOctets(ChannelId channel) const {
    return channel < is_decoded.size() && is_decoded[channel];
  }

  /// To be asked before anything is written at `time`.
  bool keyframeDue(LogTime time) const {
    return packets_since >= options.packets ||
           (packets_since > 0 && time - keyframe_time >= options.span);
  }

  bool hasShareFor(std::uint64_t bytes) const {
    return (keyframe_bytes + bytes) * (kKeyframeShare - 1) <= message_bytes;
  }

  /// Does nothing when the rules allow no keyframe; an error is the disk's.
  Status writeDueKeyframe() {
    // As of the last packet, which is the keyframe's own time: a restatement that times out later
    // may still be completed by a packet at that time.
    if (state.restatementOpen() || !hasShareFor(expected_bytes)) return {};
    const std::string text = keyframeText(state);
    expected_bytes = text.size();
    if (!hasShareFor(text.size())) return {};
    keyframe_bytes += text.size();
    // As late as possible, so that the keyframe is not out of order itself; but never behind a
    // later packet.
    return writeKeyframe(text, went_back ? folded_time : last_time);
  }

  Status writeKeyframe(std::string_view text, LogTime time) {
    if (!keyframe_channel) {
      const Result<ChannelId> added = log.addChannel(std::string(profile::kKeyframeTopic),
                                                     std::string(profile::kKeyframeEncoding), {});
      if (!added) {
        // No channel id is free: the session is stored all the same, and read from its start.
        makes_keyframes = false;
        return {};
      }
      keyframe_channel = *added;
    }
    packets_since = 0;
    keyframe_time = time;
    return log.write(*keyframe_channel, keyframe_count++, time, time.time_since_epoch().count(),
                     bytesOf(text));
  }

  Status write(ChannelId channel, std::uint32_t sequence, LogTime time,
               std::int64_t publish_time_ns, ByteView payload, const Packet* packet) {
    went_back = went_back || time < last_time;
    if (packet != nullptr && time < folded_time) makes_keyframes = false;
    Status kept;
    // A packet directly follows the octets that it was decoded from.
    if (makes_keyframes && !followsOctets(channel) && keyframeDue(time)) kept = writeDueKeyframe();
    // Also after a failed keyframe: the log then counts this message as refused too.
    const Status written = log.write(channel, sequence, time, publish_time_ns, payload);
    if (!kept) return kept;
    if (!written) return written;
    if (!begun) {
      begun = true;
      keyframe_time = time;
    }
    last_time = std::max(last_time, time);
    message_bytes += payload.size();
    if (packet == nullptr) return {};
    folded_time = std::max(folded_time, time);
    foldPacket(state, time, *packet);
    ++packets_since;
    return {};
  }
};

SessionWriter::SessionWriter(LogWriter log, const KeyframeOptions& options)
    : impl_(std::make_unique<Impl>(std::move(log), options)) {}
SessionWriter::~SessionWriter() = default;
SessionWriter::SessionWriter(SessionWriter&&) noexcept = default;
SessionWriter& SessionWriter::operator=(SessionWriter&&) noexcept = default;

Status SessionWriter::beginWith(const SessionState& preceding, LogTime moment) {
  Impl& session = *impl_;
  if (session.begun) {
    return Error{ErrorKind::bad_argument, "the preceding state must come before any message", {}};
  }
  session.begun = true;
  session.last_time = moment;
  session.folded_time = moment;
  const std::string text = keyframeText(preceding);
  if (text.empty()) {
    session.keyframe_time = moment;
    return {};
  }
  // Continue from what a reader of this log can know: the keyframe.
  Result<SessionState> keyframe = KeyframeReader().read(bytesOf(text), moment);
  if (!keyframe) return keyframe.error();
  session.state = std::move(*keyframe);
  return session.writeKeyframe(text, moment);
}

Result<ChannelId> SessionWriter::addChannel(std::string topic, std::string encoding,
                                            std::map<std::string, std::string> metadata,
                                            std::shared_ptr<const LogSchema> schema) {
  if (topic == profile::kKeyframeTopic) {
    return Error{ErrorKind::refused, "keyframes are made, not copied", {}};
  }
  const LogChannel channel{0, topic, encoding, {}};
  const bool decoded = channel.decoded();
  Result<ChannelId> id = impl_->log.addChannel(std::move(topic), std::move(encoding),
                                               std::move(metadata), std::move(schema));
  if (!id) return id;
  if (impl_->decoder_by_channel.size() <= *id) impl_->decoder_by_channel.resize(*id + 1U);
  if (impl_->is_decoded.size() <= *id) impl_->is_decoded.resize(*id + 1U);
  impl_->is_decoded[*id] = decoded;
  if (impl_->options.enabled) {
    impl_->decoder_by_channel[*id] = impl_->folder.decoderOf(channel);
  }
  return id;
}

Status SessionWriter::write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
                            std::int64_t publish_time_ns, ByteView payload) {
  Decoder* const decoder = impl_->decoderOf(channel);
  const Packet* const packet = decoder == nullptr ? nullptr : decoder->decode(payload);
  return impl_->write(channel, sequence, log_time, publish_time_ns, payload, packet);
}

Status SessionWriter::write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
                            std::int64_t publish_time_ns, ByteView payload, const Packet* packet) {
  const bool folds = impl_->decoderOf(channel) != nullptr;
  return impl_->write(channel, sequence, log_time, publish_time_ns, payload,
                      folds ? packet : nullptr);
}

Status SessionWriter::writeMark(LogTime time, std::string_view text) {
  Impl& session = *impl_;
  if (!session.mark_channel) {
    Result<ChannelId> added =
        addChannel(std::string(profile::kMarkTopic), std::string(profile::kMarkEncoding), {});
    if (!added) return added.error();
    session.mark_channel = *added;
  }
  return session.write(*session.mark_channel, session.mark_count++, time,
                       time.time_since_epoch().count(), bytesOf(markText(text)), nullptr);
}

const SessionState& SessionWriter::state() const { return impl_->state; }
std::uint64_t SessionWriter::keyframes() const { return impl_->keyframe_count; }
LogWriter& SessionWriter::log() { return impl_->log; }
const LogWriter& SessionWriter::log() const { return impl_->log; }

}  // namespace rocinante
