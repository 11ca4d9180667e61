#include "player/source/log_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "player/source/resent_packet.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxDatagramBytes = 65'507;
// A receive buffer of the usual size holds this many datagrams of a restatement.
constexpr std::size_t kBurst = 64;
constexpr Nanoseconds kBurstPeriod = std::chrono::milliseconds(10);
// An empty turn would be repeated as fast as the machine can.
constexpr Nanoseconds kShortestTurn = std::chrono::milliseconds(1);
// The longest SEQUENCE and TIME, 20 digits each, and the point.
constexpr std::size_t kLongestNumbersBytes = 41;

}  // namespace

Result<LogStream> LogStream::open(MultiLogReader& log, SessionState before, Options options) {
  LogStream stream(log, std::move(before), std::move(options));
  for (const std::string& source : log.sources()) {
    if (!stream.options_.choice.includes(source)) continue;
    const auto speaker = stream.speakers_.of(source, stream.options_.choice.nameOf(source));
    if (!speaker) return speaker.error();
  }
  if (const Status begun = stream.beginTurn(); !begun) return begun.error();
  if (const Status ready = stream.prepare(); !ready) return ready.error();
  if (stream.pending_.empty()) {
    return Error{ErrorKind::not_found, "nothing to send: no packet of the chosen sources", ""};
  }
  return stream;
}

LogStream::LogStream(MultiLogReader& log, SessionState before, Options options)
    : log_(&log),
      options_(std::move(options)),
      before_(std::move(before)),
      speakers_(options_.restate),
      decoder_(std::make_unique<PacketTextDecoder>()),
      restated_decoder_(std::make_unique<PacketTextDecoder>()) {}

std::vector<std::string> LogStream::names() {
  std::vector<std::string> names;
  for (const auto& [source, speaker] : speakers_.all()) names.push_back(speaker.name);
  std::sort(names.begin(), names.end());
  return names;
}

Result<std::optional<Due>> LogStream::due() {
  if (const Status ready = prepare(); !ready) return ready.error();
  if (pending_.empty()) return std::optional<Due>();
  return std::optional(pending_[taken_].due);
}

ByteView LogStream::take() { return bytesOf(pending_[taken_++].text); }

/// Fills `pending_` with the next packets; leaves it empty at the end.
Status LogStream::prepare() {
  if (taken_ < pending_.size()) return {};
  taken_ = 0;
  pending_.clear();
  while (pending_.empty()) {
    if (!head_read_) {
      if (const Status read = readHead(); !read) return read;
    }
    const LogTime next = head_ ? head_->log_time + shift_ : turnEnd() - Nanoseconds(1);
    Status made;
    const auto* const restating = speakers_.next();
    if (restating != nullptr && restating->second.restates <= next) {
      const LogTime moment = restating->second.restates;
      made = restateThese(sourcesSharingDevices(state_, restating->first), moment);
    } else if (head_) {
      made = sendHead();
    } else if (turn_ + 1 == options_.turns || !has_spoken_) {
      return {};
    } else {
      shift_ += std::max(options_.span.until - options_.span.from, kShortestTurn);
      ++turn_;
      made = beginTurn();
    }
    if (!made) return made;
  }
  return {};
}

Status LogStream::readHead() {
  Result<std::optional<LogMessage>> message = log_->next();
  if (!message) return message.error();
  head_ = *message;
  if (head_ && head_->log_time >= options_.span.until) head_.reset();
  head_read_ = true;
  return {};
}

Status LogStream::sendHead() {
  head_read_ = false;
  if (head_->channel->encoding != decoder_->encoding()) return {};
  const Packet* packet = decoder_->decode(head_->payload);
  if (packet == nullptr || !options_.choice.includes(packet->header.source)) return {};
  const bool is_applied = state_.apply(head_->log_time, *packet) == Applied::yes;
  // They would accumulate; they are in the packet's own lines.
  state_.takeEvents();
  if (!is_applied) return {};
  const auto lines = statementLines(textOf(head_->payload), *packet, options_.choice.devices);
  if (lines.empty() && !packet->statements.empty()) return {};
  const std::string_view source = packet->header.source;
  const auto speaker = speakers_.of(source, options_.choice.nameOf(source));
  if (!speaker) return speaker.error();
  PacketHeader header;
  // As a part it would make receivers forget what another part, which they may lack, says.
  header.restated = packet->header.restated;
  return say(**speaker, header, lines, head_->log_time + shift_);
}

Status LogStream::say(LogSpeaker& speaker, PacketHeader header,
                      const std::vector<std::string_view>& lines, LogTime moment) {
  const bool is_own_restatement = header.part.has_value();
  header.source = speaker.name;
  header.run = options_.run;
  header.sequence = speaker.sequence;
  header.time_ns =
      options_.epoch_ns + options_.speed.realDuration(moment - options_.span.from).count();
  // A part stays whole: the parts were counted before.
  const std::size_t most_bytes = is_own_restatement ? kMaxDatagramBytes : options_.mtu_bytes;
  for (std::string& text : packetsOf(header, lines, most_bytes)) {
    if (text.size() > kMaxDatagramBytes) {
      return Error{ErrorKind::unsupported,
                   fmt::format("a packet of {} bytes with its new header does not fit a datagram",
                               text.size()),
                   speaker.name};
    }
    const auto bursts = static_cast<std::int64_t>(pending_.size() / kBurst);
    const LogTime due = moment + options_.speed.logDuration(kBurstPeriod * bursts);
    pending_.push_back({Due{due, turn_, is_own_restatement}, std::move(text)});
  }
  if (speaker.sequence == 0) speakers_.begin(speaker, moment);
  speaker.sequence = *header.sequence;
  has_spoken_ = true;
  return {};
}

Status LogStream::beginTurn() {
  state_ = before_;
  head_read_ = has_spoken_ = false;
  std::set<std::string, std::less<>> sources;
  for (const auto& source : before_.sources()) sources.insert(source.first);
  for (const auto& [source, speaker] : speakers_.all()) {
    // Receivers must also forget what a source that says nothing before the turn said in the last.
    if (speaker.sequence > 0) sources.insert(source);
  }
  const LogTime now = options_.span.from + shift_;
  if (const Status sent = restateThese(sources, now); !sent) return sent;
  speakers_.spread(now);
  return log_->seek(TapePosition::at(options_.span.from), MultiLogReader::Which::folded);
}

RestatementOptions LogStream::restatementOptions(std::string_view part_id) const {
  std::size_t longer = kLongestNumbersBytes + encodeName(options_.run).size() + 1;
  for (const auto& [source, name] : options_.choice.names) {
    longer = std::max(longer, kLongestNumbersBytes + encodeName(options_.run).size() + 1 +
                                  encodeName(name).size());
  }
  RestatementOptions how;
  how.part_id = part_id;
  how.mtu_bytes = options_.mtu_bytes > longer ? options_.mtu_bytes - longer : 1;
  return how;
}

Status LogStream::restateThese(const std::set<std::string, std::less<>>& sources, LogTime moment) {
  // Long enough for any count of restatements; each speaker writes its own ID.
  const RestatementOptions how = restatementOptions("r18446744073709551615");
  std::vector<std::string> texts;
  if (sources.size() > 1) texts = restateAll(state_, how);
  for (const std::string& source : sources) {
    if (sources.size() > 1 && state_.sources().contains(source)) continue;
    for (std::string& text : restate(state_, source, how)) texts.push_back(std::move(text));
  }
  std::map<std::string, std::string, std::less<>> ids;
  for (const std::string& text : texts) {
    const Packet* packet = restated_decoder_->decode(bytesOf(text));
    if (packet == nullptr || !sources.contains(packet->header.source)) continue;
    const std::string source(packet->header.source);
    if (!options_.choice.includes(source)) continue;
    const auto speaker = speakers_.of(source, options_.choice.nameOf(source));
    if (!speaker) return speaker.error();
    std::string& id = ids[source];
    if (id.empty()) id = fmt::format("r{}", ++(*speaker)->restatements);
    PacketHeader header;
    header.restated = true;
    header.part = packet->header.part;
    header.part->id = id;
    speakers_.restated(**speaker, moment);
    const auto lines = statementLines(text, *packet, options_.choice.devices);
    if (const Status sent = say(**speaker, header, lines, moment); !sent) return sent;
  }
  return {};
}

}  // namespace rocinante
