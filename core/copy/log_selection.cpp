#include "core/copy/log_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/pattern.h"
#include "core/log/log_profile.h"
#include "core/packet/statement_device.h"
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
  wants_all_ = sources_.empty() && devices_.empty();
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
    if (channel.folded() && answer != Answer::yes) wants_all_ = false;
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
      const bool by_what_it_says = !sources_.empty() || !devices_.empty();
      if (by_what_it_says && answer != Answer::no) waits_[octets.id] = true;
    }
  }
}

bool Selection::waitsForPacket(const LogMessage& octets) const {
  const ChannelId id = octets.channel->id;
  return id < waits_.size() && waits_[id];
}

bool Selection::wants(const LogMessage& message) {
  const ChannelId id = message.channel->id;
  const Answer answer = id < by_channel_.size() ? by_channel_[id] : Answer::yes;
  if (answer == Answer::no || answer == Answer::yes) return answer == Answer::yes;
  const Packet* const packet = decoder_->decode(message.payload);
  if (packet == nullptr) return false;
  return answer == Answer::by_packet ? wantsPacket(*packet) : wantsRestated(*packet);
}

bool Selection::wantsPacket(const Packet& packet) const {
  if (!allows(sources_, std::string(packet.header.source))) return false;
  return devices_.empty() || std::ranges::any_of(packet.statements, [&](const Statement& each) {
           return isAboutDevice(each, devices_);
         });
}

bool Selection::wantsRestated(const Packet& packet) const {
  if (std::ranges::binary_search(gone_sources_, std::string(packet.header.source))) return false;
  return wantsPacket(packet);
}

}  // namespace rocinante
