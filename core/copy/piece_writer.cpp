#include "core/copy/piece_writer.h"

#include <algorithm>

#include "core/log/log_profile.h"
#include "core/mcap/records.h"
#include "core/packet/restatement.h"

namespace rocinante {
namespace {

/// Bytes of a message's entry in its chunk's index.
constexpr std::uint64_t kIndexBytes = 16;
/// Bytes of the statistics, chunk indexes and rocinante.end of a small log.
constexpr std::uint64_t kEndBytes = 1024;

}  // namespace

Result<PieceWriter> PieceWriter::start(std::unique_ptr<ByteSink> sink,
                                       const PieceOptions& options) {
  Result<LogWriter> log = LogWriter::createOn(std::move(sink), options.log, options.session_id);
  if (!log) return log.error();
  if (options.origin) log->setOrigin(*options.origin);
  return PieceWriter(SessionWriter(std::move(*log), options.keyframes));
}

Status PieceWriter::begin(const SessionState& preceding, LogTime moment) {
  begun_ = true;
  return session_.beginWith(preceding, moment);
}

Status PieceWriter::add(const CopyItem& item) {
  switch (item.kind) {
    case CopyItem::Kind::opening:
      if (!begun_) return begin(item.preceding->state, item.time);
      if (session_.state().sameAs(item.preceding->state)) return {};
      return sayAgain(item.preceding->state, item.time);
    case CopyItem::Kind::lead:
    case CopyItem::Kind::message:
      begun_ = true;
      return addMessage(item);
    case CopyItem::Kind::loss:
      begun_ = true;
      ++counts_.losses;
      return session_.log().writeLoss(*item.loss);
    case CopyItem::Kind::mark:
      begun_ = true;
      ++counts_.marks;
      return session_.writeMark(item.time, item.mark->text);
  }
  return {};
}

Status PieceWriter::addMessage(const CopyItem& item) {
  const LogMessage& message = item.message;
  // What was lost or left out before a decoded packet must not orphan it: its state is restated.
  const bool follows_octets = octets_before_.take(message);
  const bool lead =
      (item.kind == CopyItem::Kind::lead && message.channel->captured()) ||
      (message.channel->decoded() && (item.kind == CopyItem::Kind::lead || !follows_octets));
  const Result<ChannelId> channel = channelFor(*message.channel, lead);
  if (!channel) return channel.error();
  if (message.channel->captured() && !lead) {
    if (counts_.messages == 0) counts_.start = item.time;
    counts_.end = std::max(counts_.end, item.time);
    ++counts_.messages;
  } else if (message.channel->decoded() && !lead) {
    ++counts_.decoded;
  } else if (message.channel->folded()) {
    ++counts_.restated;
  }
  countBytes(message.payload.size());
  return session_.write(*channel, message.sequence, item.time, item.publish_time_ns,
                        message.payload);
}

Status PieceWriter::addDecoded(const CopyItem& octets,
                               const std::map<std::string, std::string>& metadata,
                               std::string_view text) {
  const LogChannel& channel = *octets.message.channel;
  std::map<std::string, std::string> all = channel.metadata;
  for (const auto& [key, value] : metadata) all[key] = value;
  const Result<ChannelId> id = addChannel(
      {std::string(profile::kDecodedPrefix) + channel.topic, "rk1", std::move(all), {}}, nullptr);
  if (!id) return id.error();
  ++counts_.decoded;
  countBytes(text.size());
  return session_.write(*id, octets.message.sequence, octets.time, octets.publish_time_ns,
                        bytesOf(text));
}

Status PieceWriter::sayAgain(const SessionState& state, LogTime time) {
  const Result<ChannelId> channel =
      addChannel({std::string(profile::kRestatedKeyframeTopic), "rk1", {}, {}}, nullptr);
  if (!channel) return channel.error();
  RestatementOptions options;
  options.by = "merge";
  options.part_id = "m";
  for (const std::string& datagram : restateAll(state, options)) {
    ++counts_.restated;
    countBytes(datagram.size());
    if (Status written = session_.write(*channel, restated_count_++, time,
                                        time.time_since_epoch().count(), bytesOf(datagram));
        !written) {
      return written;
    }
  }
  return {};
}

Result<ChannelId> PieceWriter::channelFor(const LogChannel& channel, bool restated) {
  ChannelIds& ids = restated ? restated_ids_ : ids_;
  if (const auto known = ids.find(&channel); known != ids.end()) return known->second;
  const Result<ChannelId> id = addChannel(
      {(restated ? std::string(profile::kRestatedPrefix) : std::string()) + channel.topic,
       channel.encoding, channel.metadata, channel.schema ? *channel.schema : LogSchema{}},
      channel.schema);
  if (id) ids.emplace(&channel, *id);
  return id;
}

Result<ChannelId> PieceWriter::addChannel(ChannelKey key, std::shared_ptr<const LogSchema> schema) {
  if (const auto known = channels_.find(key); known != channels_.end()) return known->second;
  const Result<ChannelId> id =
      session_.addChannel(key.topic, key.encoding, key.metadata, std::move(schema));
  if (!id) return id.error();
  if (LogChannel{*id, key.topic, key.encoding, {}}.captured()) ++counts_.channels;
  channels_.emplace(std::move(key), *id);
  return id;
}

Status PieceWriter::addAttachment(const LogAttachment& attachment, ByteView data) {
  ++counts_.attachments;
  return session_.log().writeAttachment(attachment.name, attachment.media_type, attachment.log_time,
                                        data);
}

void PieceWriter::forgetInputs() {
  ids_.clear();
  restated_ids_.clear();
}

void PieceWriter::countBytes(std::size_t payload_bytes) {
  const std::uint64_t written = session_.log().bytesWritten();
  if (written != chunk_start_) {
    // The chunk is in the file, with its indexes.
    chunk_start_ = written;
    pending_bytes_ = 0;
    index_bytes_ = 0;
  }
  pending_bytes_ += mcap::kPrefixBytes + mcap::kMessageHeaderBytes + payload_bytes;
  index_bytes_ += kIndexBytes;
}

std::uint64_t PieceWriter::bytesSoFar() const {
  return session_.log().bytesWritten() + pending_bytes_ + index_bytes_ + kEndBytes;
}

Status PieceWriter::finish(std::string reason) {
  Status closed = session_.log().close(std::move(reason));
  counts_.keyframes = session_.keyframes();
  counts_.bytes = session_.log().bytesWritten();
  return closed;
}

}  // namespace rocinante
