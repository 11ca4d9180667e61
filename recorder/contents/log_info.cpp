#include "recorder/contents/log_info.h"

#include <algorithm>
#include <iterator>

#include "core/base/hash.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_or_log.h"
#include "core/log/content_hash.h"
#include "core/log/log_profile.h"
#include "core/session/marks.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMessagesBetweenProgress = 1U << 14U;

class Collector {
 public:
  Collector(const LogReader& reader, LogInfo& info, std::size_t max_events)
      : info_(info), summary_(reader.summary()), max_events_(max_events) {
    for (const LogChannel& channel : reader.channels()) {
      if (by_channel_.size() <= channel.id) by_channel_.resize(channel.id + 1U);
      PerChannel& mine = by_channel_[channel.id];
      mine.activity = Activity(summary_.start, summary_.end);
      mine.info.channel = channel;
    }
  }

  void add(const LogMessage& message) {
    PerChannel& mine = by_channel_[message.channel->id];
    ChannelInfo& info = mine.info;
    if (info.messages++ == 0) info.first = info.last = message.log_time;
    if (const Nanoseconds gap = message.log_time - info.last; gap > info.longest_gap) {
      info.longest_gap = gap;
      info.gap_from = info.last;
    }
    info.last = message.log_time;
    mine.activity.add(message.log_time);
    hash_.add(message);
    if (message.channel->captured()) stream_.add(message.payload);
    if (message.channel->topic == profile::kKeyframeTopic) ++info_.keyframes;
    if (message.channel->topic == profile::kMarkTopic) {
      if (auto text = parseMark(message.payload)) {
        ++info_.marks;
        addEvent({message.log_time, {}, std::move(*text)});
      }
    }
    const bool captured = message.channel->captured();
    if (captured) ++info_.messages;
    events_.clear();
    const bool is_packet = folder_.fold(state_, message, &events_).packet != nullptr;
    if (captured && is_packet) ++info_.packets;
    if (message.channel->decoded()) ++info_.decoded;
    for (Event& event : events_) addEvent(std::move(event));
  }

  /// Merges the marks of LOG.marks in time order, after other events of equal time.
  void addMarks(std::vector<Event> marks) {
    info_.events += marks.size();
    info_.marks += marks.size();
    std::vector<Event>& events = info_.first_events;
    const std::size_t own = events.size();
    std::ranges::move(marks, std::back_inserter(events));
    std::inplace_merge(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(own),
                       events.end(),
                       [](const Event& a, const Event& b) { return a.time < b.time; });
    if (events.size() > max_events_) events.resize(max_events_);
  }

  /// What is at rest is judged by the cell that the log carries.
  void finish(const LogReader& reader) {
    CellOptions options;
    options.geometry = false;
    const Result<Cell> cell =
        carriesCell(reader) ? loadCellOrLog(reader.name(), options) : Result<Cell>(Error{});
    info_.account = logAccount(reader, state_, cell ? &*cell : nullptr);
    for (const auto& [source, counts] : state_.counts()) leaveOutBeyondLimits(source, counts);
    info_.content_sha256 = hash_.finish();
    info_.decoded_sha256 = hash_.finishDecoded();
    info_.stream_sha256 = hexOf(stream_.finish());
    for (const auto& [source, counts] : state_.counts()) info_.source_gap += counts.gap;
    for (PerChannel& mine : by_channel_) {
      if (mine.info.channel.topic.empty() && mine.info.messages == 0) continue;  // id not in use
      mine.info.activity = mine.activity.parts();
      auto& where = mine.info.channel.captured() ? info_.channels : info_.own_channels;
      where.push_back(std::move(mine.info));
    }
  }

 private:
  struct PerChannel {
    ChannelInfo info;
    Activity activity{LogTime{}, LogTime{}};
  };

  void leaveOutBeyondLimits(const std::string& source, const SourceCounts& counts) {
    const std::uint64_t many = counts.faults[static_cast<std::size_t>(PacketFault::too_many)];
    if (many == 0) return;
    info_.account.left_out.leaveOut(
        {.kind = "value",
         .name = source,
         .reason = "too_many: beyond a limit of packet text or of the state",
         .count = many,
         .severity = Severity::warning});
  }

  void addEvent(Event event) {
    if (info_.events++ < max_events_) info_.first_events.push_back(std::move(event));
  }

  LogInfo& info_;
  const LogSummary& summary_;
  std::size_t max_events_;
  std::vector<PerChannel> by_channel_;
  MessageFolder folder_;
  ContentHash hash_;
  Sha256 stream_;
  SessionState state_;
  std::vector<Event> events_;  ///< of the message being added
};

}  // namespace

double ChannelInfo::rateHz() const {
  const auto span = (last - first).count();
  if (messages < 2 || span <= 0) return 0;
  return static_cast<double>(messages - 1) * 1e9 / static_cast<double>(span);
}

Result<LogInfo> logInfo(const std::filesystem::path& path,
                        const std::function<void(double)>& progress, std::size_t max_events) {
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  LogInfo info;
  info.name = reader->name();
  info.summary = reader->summary();
  info.storage = reader->storage();
  Collector collector(*reader, info, max_events);
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
  Result<std::vector<Event>> marks = readMarks(path);
  if (!marks) return marks.error();
  collector.addMarks(std::move(*marks));
  collector.finish(*reader);
  info.loss_spans = reader->losses();
  for (const LossSpan& span : info.loss_spans) info.losses += span.counts;
  info.attachments = reader->attachments();
  info.damage = reader->damage();
  return info;
}

}  // namespace rocinante
