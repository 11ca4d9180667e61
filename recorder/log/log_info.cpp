#include "recorder/log/log_info.h"

#include <algorithm>
#include <map>
#include <memory>

#include "core/log/content_hash.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMessagesBetweenProgress = 1U << 14U;

class Collector {
 public:
  Collector(const LogReader& reader, LogInfo& info) : info_(info), summary_(reader.summary()) {
    for (const LogChannel& channel : reader.channels()) {
      if (by_channel_.size() <= channel.id) by_channel_.resize(channel.id + 1U);
      PerChannel& mine = by_channel_[channel.id];
      mine.info.channel = channel;
      if (channel.folded()) mine.decoder = decoderFor(channel.encoding);
    }
  }

  void add(const LogMessage& message) {
    PerChannel& mine = by_channel_[message.channel->id];
    ChannelInfo& info = mine.info;
    if (info.messages++ == 0) info.first = message.log_time;
    info.last = message.log_time;
    ++info.activity[partOf(message.log_time)];
    hash_.add(message);
    if (message.channel->topic == "/rocinante/keyframe") ++info_.keyframes;
    const bool captured = message.channel->captured();
    if (captured) ++info_.messages;
    if (mine.decoder == nullptr) return;
    const Packet* const packet = mine.decoder->decode(message.payload);
    if (packet == nullptr) return;
    if (captured) ++info_.packets;
    state_.apply(message.log_time, *packet);
    info_.events += state_.takeEvents().size();
  }

  void finish() {
    info_.content_sha256 = hash_.finish();
    for (const auto& [source, counts] : state_.counts()) info_.source_gap += counts.gap;
    for (PerChannel& mine : by_channel_) {
      if (mine.info.channel.topic.empty() && mine.info.messages == 0) continue;  // id not in use
      auto& where = mine.info.channel.captured() ? info_.channels : info_.own_channels;
      where.push_back(std::move(mine.info));
    }
  }

 private:
  struct PerChannel {
    ChannelInfo info;
    Decoder* decoder = nullptr;
  };

  Decoder* decoderFor(const std::string& encoding) {
    auto found = decoders_.find(encoding);
    if (found == decoders_.end()) found = decoders_.emplace(encoding, makeDecoder(encoding)).first;
    return found->second.get();
  }

  std::size_t partOf(LogTime time) const {
    const double span = static_cast<double>((summary_.end - summary_.start).count());
    if (span <= 0 || time <= summary_.start) return 0;
    const double done = static_cast<double>((time - summary_.start).count()) / span;
    return std::min(static_cast<std::size_t>(done * kActivityParts), kActivityParts - 1);
  }

  LogInfo& info_;
  const LogSummary& summary_;
  std::vector<PerChannel> by_channel_;
  std::map<std::string, std::unique_ptr<Decoder>> decoders_;
  ContentHash hash_;
  SessionState state_;
};

}  // namespace

double ChannelInfo::rateHz() const {
  const auto span = (last - first).count();
  if (messages < 2 || span <= 0) return 0;
  return static_cast<double>(messages - 1) * 1e9 / static_cast<double>(span);
}

Result<LogInfo> logInfo(const std::filesystem::path& path,
                        const std::function<void(double)>& progress) {
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  LogInfo info;
  info.name = reader->name();
  info.summary = reader->summary();
  info.storage = reader->storage();
  Collector collector(*reader, info);
  const double expected = static_cast<double>(std::max<std::uint64_t>(1, info.summary.messages));
  for (std::uint64_t read = 0;; ++read) {
    const Result<std::optional<LogMessage>> message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    collector.add(**message);
    if (progress && read % kMessagesBetweenProgress == 0) {
      progress(std::min(1.0, static_cast<double>(read) / expected));
    }
  }
  collector.finish();
  info.loss_spans = reader->losses();
  for (const LossSpan& span : info.loss_spans) info.losses += span.counts;
  info.attachments = reader->attachments();
  info.damage = reader->damage();
  return info;
}

}  // namespace rocinante
