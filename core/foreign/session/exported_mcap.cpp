#include "core/foreign/session/exported_mcap.h"

#include <utility>

#include "core/base/version.h"

namespace rocinante {

Result<ExportedMcap> ExportedMcap::start(std::unique_ptr<ByteSink> sink, std::string profile) {
  Result<mcap::Writer> writer =
      mcap::Writer::start(std::move(sink), {}, {std::move(profile), version()});
  if (!writer) return writer.error();
  return ExportedMcap(std::move(*writer));
}

ExportedMcap::ChannelEntry* ExportedMcap::addChannel(const std::string& key, mcap::Channel channel,
                                                     const std::string& shown) {
  if (channels_.size() == kMostChannels) {
    if (beyond_++ == 0) first_beyond_ = channel.topic;
    return nullptr;
  }
  ChannelEntry entry;
  entry.id = static_cast<std::uint16_t>(channels_.size());
  entry.topic = &topics_.try_emplace(channel.topic, Topic{shown, 0}).first->second;
  channel.id = entry.id;
  writer_.addChannel(std::move(channel));
  return &channels_.emplace(key, entry).first->second;
}

Status ExportedMcap::write(std::string_view topic, const MessageSchema& schema, LogTime time,
                           ByteView message, const std::map<std::string, std::string>& metadata) {
  auto found = channels_.find(topic);
  ChannelEntry* channel = found == channels_.end() ? nullptr : &found->second;
  if (channel == nullptr) {
    auto [known, is_new] = schemas_.try_emplace(schema.name, schemas_.size() + 1);
    if (is_new) writer_.addSchema({known->second, schema.name, schema.encoding, schema.data});
    channel = addChannel(std::string(topic),
                         {0, known->second, std::string(topic), schema.message_encoding, metadata},
                         schema.name);
    if (channel == nullptr) return {};
  }
  const auto nanoseconds = static_cast<std::uint64_t>(nanosecondsOf(time));
  ++channel->topic->messages;
  return writer_.write({channel->id, channel->sequence++, nanoseconds, nanoseconds, message});
}

Status ExportedMcap::writeRaw(const std::string& topic, const std::string& encoding,
                              const std::map<std::string, std::string>& metadata,
                              const mcap::Message& message) {
  // A log may have several channels of one topic, told apart by their metadata.
  std::string key = topic + "\n" + encoding;
  for (const auto& [name, value] : metadata) key += "\n" + name + "=" + value;
  auto found = channels_.find(key);
  ChannelEntry* channel = found == channels_.end() ? nullptr : &found->second;
  if (channel == nullptr) {
    channel = addChannel(key, {0, 0, topic, encoding, metadata}, encoding);
    if (channel == nullptr) return {};
  }
  mcap::Message copy = message;
  copy.channel_id = channel->id;
  ++channel->topic->messages;
  return writer_.write(copy);
}

Status ExportedMcap::writeAttachment(const mcap::Attachment& attachment) {
  return writer_.writeAttachment(attachment);
}

void ExportedMcap::addLeftOut(Account& account) const {
  if (beyond_ == 0) return;
  account.leaveOut({.kind = "message",
                    .reason = "an MCAP file holds at most 65,535 channels, and these are of others",
                    .first = first_beyond_,
                    .count = beyond_,
                    .severity = Severity::warning});
}

Status ExportedMcap::finish() { return writer_.finish(); }

}  // namespace rocinante
