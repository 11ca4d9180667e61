#include "recorder/doctor/profile_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/log/loss_message.h"
#include "core/session/marks.h"

namespace rocinante {
namespace {

constexpr auto kLastTime = static_cast<std::uint64_t>(kLastLogTime.time_since_epoch().count());

LogTime timeOf(std::uint64_t time) {
  return LogTime(Nanoseconds(static_cast<std::int64_t>(std::min(time, kLastTime))));
}

std::optional<std::string> entryOf(const std::map<std::string, std::string>& entries,
                                   std::string_view key) {
  const auto found = entries.find(std::string(key));
  if (found == entries.end()) return std::nullopt;
  return found->second;
}

/// The first line of `mine` that `theirs` lacks.
std::string firstDifference(const std::string& mine, const std::string& theirs) {
  const auto differ = std::ranges::mismatch(mine, theirs);
  const auto at = static_cast<std::size_t>(differ.in1 - mine.begin());
  const std::size_t line = at == 0 ? 0 : mine.rfind('\n', at - 1) + 1;
  return plainText(mine.substr(line, std::min(mine.find('\n', line), line + 200) - line));
}

}  // namespace

void ProfileRules::channel(const mcap::Channel& channel, std::uint64_t offset) {
  Known known;
  known.channel = {channel.id, channel.topic, channel.message_encoding, channel.metadata};
  if (!channels_.try_emplace(channel.id, known).second) return;
  Known& mine = channels_[channel.id];
  const LogChannel& as_read = mine.channel;
  if (channel.schema_id != 0 && !as_read.metadata.contains(std::string(profile::kImportedKey))) {
    report_.add(
        "profile-schema", offset,
        fmt::format("channel {} has a schema, which only imported channels may have", channel.id));
  }
  if (!as_read.topic.starts_with('/')) {
    report_.add("topic", offset,
                fmt::format("the topic \"{}\" does not begin with /", plainText(as_read.topic)));
  }
  std::string_view wanted;
  if (as_read.topic == profile::kKeyframeTopic) wanted = profile::kKeyframeEncoding;
  if (as_read.topic == profile::kMarkTopic) wanted = profile::kMarkEncoding;
  if (as_read.topic == profile::kLossTopic) wanted = profile::kLossEncoding;
  // A copy of another writer's log keeps its encodings, which are not judged.
  if (!wanted.empty() && as_read.encoding != wanted) {
    report_.add("encoding", offset,
                fmt::format("channel {}, {}, has the message encoding \"{}\"", channel.id,
                            plainText(as_read.topic), plainText(as_read.encoding)));
  }
  if (as_read.decoded() && !as_read.metadata.contains(std::string(profile::kDecoderKey))) {
    report_.add("decoder", offset,
                fmt::format("channel {}, {}, does not name its decoder", channel.id,
                            plainText(as_read.topic)));
  }
  if (as_read.topic == profile::kKeyframeTopic) {
    if (keyframe_channel_) {
      report_.add("keyframe-place", offset, "a second channel of keyframes");
    } else {
      keyframe_channel_ = channel.id;
    }
  }
  mine.decoder = folder_.decoderOf(as_read);
}

void ProfileRules::metadata(const mcap::Metadata& metadata, std::uint64_t offset) {
  if (metadata.name == profile::kSession) session(metadata, offset);
  if (metadata.name == profile::kEnd) closing(metadata, offset);
}

void ProfileRules::session(const mcap::Metadata& metadata, std::uint64_t offset) {
  if (session_) {
    report_.add("session", offset, "a second rocinante.session");
    return;
  }
  session_ = metadata.metadata;
  const std::optional<std::string> format = entryOf(*session_, profile::kFormatKey);
  if (format != profile::kFormat) {
    report_.add("session", offset,
                fmt::format("rocinante.session has the format \"{}\"; only 1 is known",
                            plainText(format.value_or("").substr(0, 40))));
  }
  if (entryOf(*session_, profile::kSessionIdKey).value_or("").empty()) {
    report_.add("session", offset, "rocinante.session has no session_id");
  }
  const std::optional<std::string> origin = entryOf(*session_, profile::kOriginKey);
  if (origin && profile::parseOrigin(*origin).value_or(LogTime::min()) < LogTime{}) {
    report_.add("session", offset,
                fmt::format("origin_ns is \"{}\", not a decimal number of nanoseconds",
                            plainText(origin->substr(0, 40))));
  }
  if (any_captured_) {
    report_.add("session-place", offset,
                "rocinante.session comes after the first captured message");
  }
}

void ProfileRules::closing(const mcap::Metadata& metadata, std::uint64_t offset) {
  if (end_offset_) {
    report_.add("end", offset, "a second rocinante.end");
    return;
  }
  end_offset_ = offset;
  if (!entryOf(metadata.metadata, profile::kReasonKey)) {
    report_.add("end", offset, "rocinante.end gives no reason");
  }
  if (!session_) return;
  for (const std::string_view key : {profile::kSessionIdKey, profile::kOriginKey}) {
    if (entryOf(metadata.metadata, key) != entryOf(*session_, key)) {
      report_.add("origin", offset, fmt::format("{} differs from that of rocinante.session", key));
    }
  }
}

void ProfileRules::end(std::uint64_t offset, std::uint64_t last_offset) {
  if (!session_) report_.add("session", offset, "rocinante.session is missing");
  if (session_ && any_captured_ && !session_->contains(std::string(profile::kOriginKey))) {
    report_.add("session", offset,
                "the log has captured messages, but rocinante.session has no origin_ns");
  }
  if (!end_offset_) {
    report_.add("end", offset, "rocinante.end is missing");
  } else if (*end_offset_ != last_offset) {
    report_.add("end", *end_offset_, "rocinante.end is not the last record before DataEnd");
  }
}

void ProfileRules::message(const mcap::Message& message, std::uint64_t offset) {
  const auto found = channels_.find(message.channel_id);
  if (found == channels_.end()) return;
  const Known& known = found->second;
  if (message.log_time > kLastTime) {
    report_.add(
        "time-range", offset,
        fmt::format("a message has the log time {}; the last is 2^63 - 2", message.log_time));
    return;
  }
  const bool is_keyframe = known.channel.topic == profile::kKeyframeTopic;
  // An import keeps the order of its recording; readers go by time.
  if (message.log_time < last_time_ && !is_keyframe && !known.channel.imported()) {
    report_.add("time-order", offset,
                fmt::format("a message is {} ns earlier than one before it",
                            last_time_ - message.log_time));
  }
  last_time_ = std::max(last_time_, message.log_time);
  if (!is_keyframe) last_other_time_ = std::max(last_other_time_, message.log_time);
  octets(known, message, offset);
  if (known.channel.captured()) captured(known, message, offset);
  if (known.channel.folded()) fold(known, message, offset);
  if (is_keyframe) {
    keyframe(message, offset);
  } else if (!known.channel.folded()) {
    own(known, message, offset);
  }
}

void ProfileRules::octets(const Known& known, const mcap::Message& message, std::uint64_t offset) {
  LogMessage as_read;
  as_read.channel = &known.channel;
  as_read.sequence = message.sequence;
  as_read.log_time = timeOf(message.log_time);
  as_read.publish_time_ns = static_cast<std::int64_t>(message.publish_time);
  const bool fits = octets_before_.take(as_read);
  if (std::exchange(after_gap_, false) || fits) return;
  report_.add("decoded-place", offset,
              fmt::format("message {} on {} does not directly follow the octets that it was "
                          "decoded from",
                          message.sequence, plainText(known.channel.topic)));
}

void ProfileRules::captured(const Known& known, const mcap::Message& message,
                            std::uint64_t offset) {
  if (!any_captured_ && !session_) {
    report_.add("session-place", offset, "a captured message comes before rocinante.session");
  }
  any_captured_ = true;
  const bool judged = known.channel.encoding == "rk1" || known.channel.encoding == "octets";
  if (judged && encodingOf(message.data) != known.channel.encoding) {
    report_.add("encoding", offset,
                fmt::format("message {} on channel {} is {}, but the channel says {}",
                            message.sequence, message.channel_id, encodingOf(message.data),
                            plainText(known.channel.encoding)));
  }
}

void ProfileRules::fold(const Known& known, const mcap::Message& message, std::uint64_t offset) {
  if (known.decoder == nullptr) return;
  const Packet* const packet = known.decoder->decode(message.data);
  if (packet == nullptr) return;
  if (known.channel.captured() && !packet->header.by.empty()) {
    report_.add("restated", offset,
                fmt::format("message {} on channel {} is restated by another (by=), which "
                            "belongs on /rocinante/restated/...",
                            message.sequence, message.channel_id));
  }
  if (last_folded_time_ && message.log_time < *last_folded_time_) fold_ordered_ = false;
  last_folded_time_ = std::max(last_folded_time_.value_or(0), message.log_time);
  foldPacket(state_, timeOf(message.log_time), *packet);
}

void ProfileRules::keyframe(const mcap::Message& message, std::uint64_t offset) {
  const LogTime time = timeOf(message.log_time);
  Result<SessionState> keyframe = keyframe_reader_.read(message.data, time);
  if (!keyframe) {
    report_.add("keyframe-content", offset, keyframe.error().text());
    return;
  }
  if (!last_folded_time_ || !fold_known_) {
    // The keyframe opens a piece, or follows unreadable data: continue from its state.
    state_ = std::move(*keyframe);
    fold_known_ = true;
    return;
  }
  if (message.log_time < *last_folded_time_ || message.log_time > last_other_time_) {
    report_.add("keyframe-time", offset,
                fmt::format("a keyframe has the time {}, but the last message before it {}",
                            message.log_time, last_other_time_));
    return;
  }
  if (!fold_ordered_) {
    report_.add("keyframe-place", offset, "a keyframe follows messages that are not in time order");
    return;
  }
  if (state_.restatementOpen(timeOf(*last_folded_time_))) {
    report_.add("keyframe-place", offset, "a keyframe is inside an unfinished restatement");
    return;
  }
  if (state_.sameAs(*keyframe)) return;
  report_.add(
      "keyframe-state", offset,
      report_.broke("keyframe-state")
          ? std::string("a keyframe is not the fold of the messages before it")
          : fmt::format("a keyframe is not the fold of the messages before it: the fold has "
                        "\"{}\"",
                        firstDifference(state_.identityText(), keyframe->identityText())));
}

void ProfileRules::own(const Known& known, const mcap::Message& message, std::uint64_t offset) {
  if (known.channel.topic == profile::kLossTopic && !parseLoss(message.data)) {
    report_.add(
        "loss", offset,
        fmt::format("message {} on {} is not a valid loss", message.sequence, profile::kLossTopic));
  }
  if (known.channel.topic == profile::kMarkTopic && !parseMark(message.data)) {
    report_.add(
        "mark", offset,
        fmt::format("message {} on {} is not a valid mark", message.sequence, profile::kMarkTopic));
  }
}

}  // namespace rocinante
