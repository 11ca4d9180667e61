#include "viewer/serve/foxglove_desk.h"

#include <utility>

#include "core/foreign/foxglove/foxglove_format.h"
#include "viewer/serve/foxglove_messages.h"

namespace rocinante {
namespace {

/// The encoding of schemas that may change.
constexpr std::string_view kOfSignals = "jsonschema";

}  // namespace

FoxgloveDesk::FoxgloveDesk(const Cell& cell, std::string session)
    : session_(std::move(session)),
      format_(makeFoxgloveFormat(SignalMessages::whole)),
      messages_(&cell, *format_) {}

void FoxgloveDesk::applied(const Packet& packet, const std::vector<Event>& events) {
  messages_.notice(packet);
  known_.notice(packet);
  for (const Event& each : events) {
    if (events_.size() < kEventsKept) events_.push_back(each);
  }
}

void FoxgloveDesk::moment(LogTime time, const SessionState& state) {
  if (known_growth_ != known_.growth()) {
    known_growth_ = known_.growth();
    format_->knowSignals(known_);
  }
  // write() does not fail, and the format only where that does.
  (void)messages_.moment(*this, time, state);
  for (const Event& each : events_) {
    (void)format_->event(*this, each.time, EventLevel::info, each.source, each.text);
  }
  events_.clear();
}

void FoxgloveDesk::addChannel(std::string_view topic, const MessageSchema& schema) {
  Channel channel;
  channel.advertised = foxgloveChannel(static_cast<std::uint32_t>(channels_.size()), topic, schema);
  channel.keeps_all = schema.name == "foxglove.Log";
  if (schema.encoding == kOfSignals) channel.schema = schema.data;
  channels_.push_back(std::move(channel));
}

bool FoxgloveDesk::mayReplace(const Channel& channel, const MessageSchema& schema) const {
  return schema.encoding == kOfSignals && channel.schema != schema.data &&
         channel.schemas < kMostSchemas && channels_.size() < kMostChannels;
}

void FoxgloveDesk::replace(std::size_t channel, std::string_view topic,
                           const MessageSchema& schema) {
  const std::size_t schemas = channels_[channel].schemas;
  channels_[channel] = {};
  replaced_.push_back(static_cast<std::uint32_t>(channel));
  addChannel(topic, schema);
  channels_.back().schemas = schemas + 1;
}

Status FoxgloveDesk::write(std::string_view topic, const MessageSchema& schema, LogTime time,
                           ByteView message, const std::map<std::string, std::string>&) {
  auto found = by_topic_.find(topic);
  if (found == by_topic_.end()) {
    if (channels_.size() == kMostChannels) return {};
    found = by_topic_.emplace(topic, channels_.size()).first;
    addChannel(topic, schema);
  } else if (mayReplace(channels_[found->second], schema)) {
    replace(found->second, topic, schema);
    found->second = channels_.size() - 1;
  }
  Channel& channel = channels_[found->second];
  const std::uint64_t number = channel.messages.empty() ? 1 : channel.messages.back().number + 1;
  const std::size_t kept = channel.keeps_all ? kEventsKept : 1;
  while (channel.messages.size() >= kept) channel.messages.pop_front();
  channel.messages.push_back({time, number, Bytes(message.begin(), message.end())});
  return {};
}

}  // namespace rocinante
