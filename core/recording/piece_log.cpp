#include "core/recording/piece_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/log/log_profile.h"

namespace rocinante {
namespace {

/// How often to check that no other program deleted the file.
constexpr Nanoseconds kLookPeriod = std::chrono::seconds(1);

}  // namespace

PieceLog::PieceLog(MadePiece made, const KeyframeOptions& keyframes)
    : session_(std::move(made.log), keyframes), file_(std::move(made.file)) {}

Status PieceLog::begin(const SessionState& preceding, LogTime moment,
                       std::optional<LogTime> origin) {
  if (origin) session_.log().setOrigin(*origin);
  return session_.beginWith(preceding, moment);
}

Status PieceLog::write(const CapturedDatagram& datagram, bool decoded) {
  if (channels_.size() <= datagram.flow) channels_.resize(datagram.flow + 1);
  std::optional<ChannelId>& channel = channels_[datagram.flow];
  if (!channel) {
    const FlowChannel& flow = *datagram.channel;
    Result<ChannelId> added = session_.addChannel(flow.topic, flow.encoding, flow.metadata);
    if (!added) return added.error();
    channel = *added;
  }
  ++packets_;
  if (!start_) start_ = datagram.time;
  end_ = datagram.time;
  const auto write = [&] {
    if (!decoded) {
      return session_.write(*channel, datagram.sequence, datagram.time, datagram.publish_time_ns,
                            datagram.payload);
    }
    return session_.write(*channel, datagram.sequence, datagram.time, datagram.publish_time_ns,
                          datagram.payload, datagram.made == nullptr ? datagram.packet : nullptr);
  };
  if (datagram.made == nullptr) return write();
  Status written = write();
  return written ? writeMade(datagram, decoded) : written;
}

Status PieceLog::writeMade(const CapturedDatagram& octets, bool decoded) {
  const MadePacket& made = *octets.made;
  const std::pair key(octets.flow, made.decoder);
  auto channel = made_channels_.find(key);
  if (channel == made_channels_.end()) {
    std::map<std::string, std::string> metadata = octets.channel->metadata;
    for (const auto& [name, value] : *made.metadata) metadata[name] = value;
    const Result<ChannelId> added = session_.addChannel(
        std::string(profile::kDecodedPrefix) + octets.channel->topic, "rk1", std::move(metadata));
    if (!added) return added.error();
    channel = made_channels_.emplace(key, *added).first;
  }
  const ByteView text = bytesOf(made.text);
  if (!decoded) {
    return session_.write(channel->second, octets.sequence, octets.time, octets.publish_time_ns,
                          text);
  }
  return session_.write(channel->second, octets.sequence, octets.time, octets.publish_time_ns, text,
                        made.packet);
}

Status PieceLog::writeStep(const ClockStep& step) {
  if (!clock_channel_) {
    Result<ChannelId> added = session_.addChannel(std::string(profile::kClockTopic),
                                                  std::string(profile::kClockEncoding), {});
    if (!added) return added.error();
    clock_channel_ = *added;
  }
  // It may be written after later datagrams; the file stays in time order.
  const LogTime time = std::max(step.at, end_.value_or(LogTime{}));
  return session_.write(*clock_channel_, steps_++, time, time.time_since_epoch().count(),
                        bytesOf(clockStepText(step)));
}

Status PieceLog::close(const std::string& reason) {
  Status closed = session_.log().close(reason);
  if (closed || closed.error().kind != ErrorKind::damaged) return closed;
  if (!disturbance_) disturbance_ = closed.error();
  return {};
}

Status PieceLog::flush(SteadyTime now) {
  if (!disturbance_ && now - looked_ >= kLookPeriod) {
    looked_ = now;
    if (Status still_there = session_.log().check(); !still_there) {
      disturbance_ = still_there.error();
    }
  }
  return session_.log().flushIfDue(now);
}

std::optional<Error> PieceLog::newDisturbance() {
  if (!disturbance_ || std::exchange(disturbance_reported_, true)) return std::nullopt;
  return disturbance_;
}

PieceFacts PieceLog::facts() const {
  PieceFacts facts;
  facts.file = file_;
  for (const auto& [channel, count] : session_.log().refusedByDisk()) {
    const bool of_flow = std::ranges::find(channels_, std::optional(channel)) != channels_.end();
    if (of_flow) facts.refused += count;
  }
  facts.packets = packets_ - facts.refused;
  facts.bytes = bytes();
  facts.start = start_;
  facts.end = end_;
  if (disturbance_) facts.trouble = disturbance_->text();
  return facts;
}

void PieceLog::addRefused(std::vector<std::uint64_t>& by_flow) const {
  for (std::size_t flow = 0; flow < channels_.size(); ++flow) {
    if (!channels_[flow]) continue;
    const auto refused = session_.log().refusedByDisk().find(*channels_[flow]);
    if (refused == session_.log().refusedByDisk().end()) continue;
    if (by_flow.size() <= flow) by_flow.resize(flow + 1);
    by_flow[flow] += refused->second;
  }
}

}  // namespace rocinante
