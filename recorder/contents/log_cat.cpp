#include "recorder/contents/log_cat.h"

#include <algorithm>

#include "core/base/pattern.h"
#include "core/log/log_profile.h"
#include "core/session/marks.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

/// Output is handed over in pieces of about this size.
constexpr std::size_t kPieceBytes = 1U << 16U;

/// By channel id: whether its messages are wanted.
std::vector<bool> wantedChannels(const CatOptions& options, const LogReader& reader) {
  std::vector<bool> wanted;
  for (const LogChannel& channel : reader.channels()) {
    if (wanted.size() <= channel.id) wanted.resize(channel.id + 1U, false);
    wanted[channel.id] = options.selection.channels.empty()
                             ? channel.captured()
                             : anyPatternMatches(options.selection.channels, channel.topic);
  }
  return wanted;
}

/// The marks beside a log as messages, as a tool would bake them in.
class MarkMessages {
 public:
  static Result<MarkMessages> of(const LogReader& reader, const CatOptions& options) {
    MarkMessages messages;
    if (!options.selection.devices.empty()) return messages;
    if (!anyPatternMatches(options.selection.channels, profile::kMarkTopic)) return messages;
    Result<std::vector<Event>> marks = readMarks(reader.name());
    if (!marks) return marks.error();
    messages.marks_ = std::move(*marks);
    return messages;
  }

  void seek(LogTime from) {
    while (next_ < marks_.size() && marks_[next_].time < from) ++next_;
  }
  /// The next mark if it is earlier than `until`; valid until the next call.
  std::optional<LogMessage> before(LogTime until) {
    if (next_ == marks_.size() || marks_[next_].time >= until) return std::nullopt;
    const Event& mark = marks_[next_];
    payload_ = markText(mark.text);
    LogMessage message;
    message.channel = &channel_;
    message.sequence = static_cast<std::uint32_t>(next_);
    message.log_time = mark.time;
    message.publish_time_ns = mark.time.time_since_epoch().count();
    message.payload = bytesOf(payload_);
    ++next_;
    return message;
  }

 private:
  LogChannel channel_{0, std::string(profile::kMarkTopic), std::string(profile::kMarkEncoding), {}};
  std::vector<Event> marks_;
  std::size_t next_ = 0;
  std::string payload_;
};

}  // namespace

Result<std::uint64_t> catLog(LogReader& reader, const CatOptions& options, bool with_header,
                             const TextSink& out) {
  const Result<TimeRange> range = rangeOf(options.selection, reader.summary(), {});
  if (!range) return range.error();
  const std::vector<bool> wanted = wantedChannels(options, reader);
  std::optional<Selection> devices;
  if (!options.selection.devices.empty()) {
    SelectionOptions by_device;
    by_device.devices = options.selection.devices;
    devices.emplace(by_device, reader.channels());
  }
  Result<MarkMessages> marks = MarkMessages::of(reader, options);
  if (!marks) return marks.error();
  MessagePrinter printer(options.format, options.name_log ? reader.name() : std::string(),
                         reader.summary().origin);
  for (const LogChannel& channel : reader.channels()) {
    if (wanted[channel.id]) printer.makeRoomFor(channel);
  }
  std::string piece;
  if (with_header) printer.header(piece);
  if (Status found = reader.seek(range->from); !found) return found.error();
  marks->seek(range->from);
  std::uint64_t count = 0;
  // Handed over when a piece is full, and at the end.
  const auto print = [&](const LogMessage& message) -> Status {
    printer.message(message, piece);
    ++count;
    if (piece.size() < kPieceBytes) return {};
    Status written = out(piece);
    piece.clear();
    return written;
  };
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    const bool at_end = !*message || (*message)->log_time >= range->until;
    const LogTime now = at_end ? range->until : (*message)->log_time;
    while (const std::optional<LogMessage> mark = marks->before(now)) {
      if (Status printed = print(*mark); !printed) return printed.error();
    }
    if (at_end) break;
    if (!wanted[(*message)->channel->id]) continue;
    if (devices && !((*message)->channel->folded() && devices->includes(**message))) continue;
    if (Status printed = print(**message); !printed) return printed.error();
  }
  if (Status written = out(piece); !written) return written.error();
  return count;
}

}  // namespace rocinante
