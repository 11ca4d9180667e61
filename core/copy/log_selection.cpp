#include "core/copy/log_selection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "core/base/duration_text.h"
#include "core/base/pattern.h"
#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/packet/item_text.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

/// True without patterns, or if one of them matches.
bool allows(const std::vector<std::string>& patterns, const std::string& text) {
  return patterns.empty() || anyPatternMatches(patterns, text);
}

/// The first event at or after `from` whose text matches; the exact text always matches.
Result<LogTime> timeOfEvent(const std::string& pattern, LogTime from,
                            const std::vector<Event>& events) {
  for (const Event& event : events) {
    if (event.time < from) continue;
    if (patternMatches(pattern, event.text)) return event.time;
  }
  return Error{ErrorKind::not_found,
               from == TimeRange{}.from ? "no event matches"
                                        : "no event matches after the start of the range",
               pattern};
}

constexpr std::size_t kMaxTopics = 5;

bool anyTopicMatches(const LogReader& log, const std::vector<std::string>& patterns) {
  return std::ranges::any_of(log.channels(), [&](const LogChannel& channel) {
    return anyPatternMatches(patterns, channel.topic);
  });
}

/// "there are /udp/19960/arm, /udp/19960/gantry and 12 more".
std::string topicsOf(const LogReader& log) {
  std::vector<std::string> topics;
  for (const LogChannel& channel : log.channels()) {
    if (channel.captured() && std::ranges::find(topics, channel.topic) == topics.end()) {
      topics.push_back(channel.topic);
    }
  }
  const std::size_t shown = std::min(topics.size(), kMaxTopics);
  const std::span names(topics);
  std::string text = fmt::format("there {} {}", topics.size() == 1 ? "is" : "are",
                                 fmt::join(names.first(shown), ", "));
  if (shown < topics.size()) text += fmt::format(" and {} more", topics.size() - shown);
  return plainText(text);
}

std::string reasonOf(const LogReader& log, const SelectionOptions& selection,
                     const TimeRange& range) {
  const LogSummary& summary = log.summary();
  if (!log.damage().empty()) {
    const DamageSpan& damage = log.damage().front();
    return fmt::format("not all could be read; at byte {} {}", damage.from, damage.cause);
  }
  if (summary.messages == 0) return "the log has none";
  if (range.from > summary.end || range.until <= summary.start) {
    const auto shown = [&](LogTime time) { return secondsText(time - summary.origin, 3); };
    return fmt::format("the log goes from {} s to {} s", shown(summary.start), shown(summary.end));
  }
  if (!selection.channels.empty() && !anyTopicMatches(log, selection.channels)) {
    return "no topic matches; " + topicsOf(log);
  }
  return {};
}

}  // namespace

Result<TimeRange> rangeOf(const SelectionOptions& options, const LogSummary& summary,
                          const std::vector<Event>& events) {
  TimeRange range;
  if (!options.from.empty()) {
    const Result<LogTime> from = parseSessionTime(options.from, summary.origin, summary.end);
    if (!from) return from.error();
    range.from = *from;
  } else if (!options.from_event.empty()) {
    const Result<LogTime> from = timeOfEvent(options.from_event, range.from, events);
    if (!from) return from.error();
    range.from = *from;
  }
  if (!options.until.empty()) {
    const Result<LogTime> until = parseSessionTime(options.until, summary.origin, summary.end);
    if (!until) return until.error();
    range.until = *until;
  } else if (!options.until_event.empty()) {
    // The event that begins the range does not end it.
    const LogTime behind = range.opened() ? range.from + Nanoseconds(1) : range.from;
    const Result<LogTime> until = timeOfEvent(options.until_event, behind, events);
    if (!until) return until.error();
    range.until = *until;
  }
  if (range.from >= range.until) {
    const std::string& end = options.until.empty() ? options.until_event : options.until;
    return Error{ErrorKind::bad_argument, "the range ends before it begins", end};
  }
  return range;
}

Selection::Selection(const SelectionOptions& options, const std::vector<LogChannel>& channels)
    : sources_(options.sources), devices_(options.devices) {
  if (!options.anyChoice()) return;
  decoder_ = std::make_unique<PacketTextDecoder>();
  // An opening keyframe may state more than the channels of this log do.
  selects_all_ = sources_.empty() && devices_.empty();
  std::set<std::string> wanted_sources;
  std::set<std::string> unwanted_sources;
  for (const LogChannel& channel : channels) {
    if (by_channel_.size() <= channel.id) by_channel_.resize(channel.id + 1U, Answer::yes);
    const Answer answer = answerFor(channel, options);
    by_channel_[channel.id] = answer;
  }
  joinDecoded(channels, options);
  for (const LogChannel& channel : channels) {
    const Answer answer = by_channel_[channel.id];
    if (channel.folded() && answer != Answer::yes) selects_all_ = false;
    const auto source = channel.metadata.find("source");
    if (!channel.folded() || source == channel.metadata.end()) continue;
    (answer == Answer::no ? unwanted_sources : wanted_sources).insert(source->second);
  }
  std::ranges::set_difference(unwanted_sources, wanted_sources, std::back_inserter(gone_sources_));
}

Selection::Answer Selection::answerFor(const LogChannel& channel,
                                       const SelectionOptions& options) const {
  if (anyPatternMatches(options.not_channels, channel.topic)) return Answer::no;
  if (channel.topic == profile::kRestatedKeyframeTopic) return Answer::by_restated;
  if (!channel.folded()) return Answer::yes;
  std::string topic = channel.topic;
  if (!channel.captured()) {
    topic = profile::capturedTopic(topic);
    if (anyPatternMatches(options.not_channels, topic)) return Answer::no;
  }
  if (!allows(options.channels, topic) && !allows(options.channels, channel.topic) &&
      !allows(options.channels, std::string(profile::kDecodedPrefix) + topic)) {
    return Answer::no;
  }
  if (!channel.decoded() && !allows(options.encodings, channel.encoding)) return Answer::no;
  if (sources_.empty() && devices_.empty()) return Answer::yes;
  if (channel.encoding != "rk1") return Answer::no;
  const auto source = channel.metadata.find("source");
  if (source == channel.metadata.end()) return Answer::by_packet;
  if (!allows(sources_, source->second)) return Answer::no;
  return devices_.empty() ? Answer::yes : Answer::by_packet;
}

/// A decoded channel is wanted as its octets are, by all that their channel says.
void Selection::joinDecoded(const std::vector<LogChannel>& channels,
                            const SelectionOptions& options) {
  std::multimap<std::string_view, ChannelId> packets;
  for (const LogChannel& channel : channels) {
    if (channel.decoded()) packets.emplace(profile::capturedTopic(channel.topic), channel.id);
  }
  waits_.resize(by_channel_.size());
  for (const LogChannel& octets : channels) {
    if (octets.encoding == "rk1") continue;
    const auto [first, last] = packets.equal_range(octets.topic);
    for (auto each = first; each != last; ++each) {
      Answer& answer = by_channel_[each->second];
      const bool left_out = anyPatternMatches(options.not_channels, octets.topic) ||
                            !allows(options.encodings, octets.encoding);
      if (left_out) answer = Answer::no;
      const bool by_contents = !sources_.empty() || !devices_.empty();
      if (by_contents && answer != Answer::no) waits_[octets.id] = true;
    }
  }
}

bool Selection::waitsForPacket(const LogMessage& octets) const {
  const ChannelId id = octets.channel->id;
  return id < waits_.size() && waits_[id];
}

bool Selection::includes(const LogMessage& message) {
  const ChannelId id = message.channel->id;
  const Answer answer = id < by_channel_.size() ? by_channel_[id] : Answer::yes;
  if (answer == Answer::no || answer == Answer::yes) return answer == Answer::yes;
  const Packet* const packet = decoder_->decode(message.payload);
  if (packet == nullptr) return false;
  return answer == Answer::by_packet ? selectsPacket(*packet) : selectsRestated(*packet);
}

bool Selection::selectsPacket(const Packet& packet) const {
  if (!allows(sources_, std::string(packet.header.source))) return false;
  return devices_.empty() || std::ranges::any_of(packet.statements, [&](const Statement& each) {
           return isAboutDevice(each, devices_);
         });
}

bool Selection::selectsRestated(const Packet& packet) const {
  if (std::ranges::binary_search(gone_sources_, std::string(packet.header.source))) return false;
  return selectsPacket(packet);
}

Error nothingChosen(const LogReader& log, const SelectionOptions& selection,
                    const TimeRange& range) {
  const std::string reason = reasonOf(log, selection, range);
  return Error{ErrorKind::not_found,
               reason.empty() ? "no message was chosen" : "no message was chosen: " + reason,
               log.name()};
}

}  // namespace rocinante
