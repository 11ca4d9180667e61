#include "viewer/serve/foxglove_desk.h"

#include <utility>

#include "core/foreign/foxglove/foxglove_format.h"
#include "viewer/serve/foxglove_messages.h"

namespace rocinante {

FoxgloveDesk::FoxgloveDesk(const Cell& cell, std::string session)
    : session_(std::move(session)), format_(makeFoxgloveFormat()), messages_(&cell, *format_) {}

void FoxgloveDesk::applied(const Packet& packet, const std::vector<Event>& events) {
  messages_.notice(packet);
  for (const Event& each : events) {
    if (events_.size() < kEventsKept) events_.push_back(each);
  }
}

void FoxgloveDesk::moment(LogTime time, const SessionState& state) {
  // write() does not fail, and the format only where that does.
  (void)messages_.moment(*this, time, state);
  for (const Event& each : events_) {
    (void)format_->event(*this, each.time, EventLevel::info, each.source, each.text);
  }
  events_.clear();
}

Status FoxgloveDesk::write(std::string_view topic, const MessageSchema& schema, LogTime time,
                           ByteView message, const std::map<std::string, std::string>&) {
  auto found = by_topic_.find(topic);
  if (found == by_topic_.end()) {
    if (channels_.size() == kMostChannels) return {};
    found = by_topic_.emplace(topic, channels_.size()).first;
    Channel channel;
    channel.advertised =
        foxgloveChannel(static_cast<std::uint32_t>(channels_.size()), topic, schema);
    channel.keeps_all = schema.name == "foxglove.Log";
    channels_.push_back(std::move(channel));
  }
  Channel& channel = channels_[found->second];
  const std::uint64_t number = channel.messages.empty() ? 1 : channel.messages.back().number + 1;
  const std::size_t kept = channel.keeps_all ? kEventsKept : 1;
  while (channel.messages.size() >= kept) channel.messages.pop_front();
  channel.messages.push_back({time, number, Bytes(message.begin(), message.end())});
  return {};
}

}  // namespace rocinante
