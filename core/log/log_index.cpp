#include "core/log/log_index.h"

#include "core/mcap/parse_record.h"

namespace rocinante {

bool addChannel(LogIndex& index, const mcap::Channel& channel) {
  const auto [place, added] = index.channels.try_emplace(channel.id);
  LogChannel& known = place->second;
  if (!added) {
    return known.topic == channel.topic && known.encoding == channel.message_encoding &&
           known.metadata == channel.metadata;
  }
  known = {channel.id, channel.topic, channel.message_encoding, channel.metadata};
  return true;
}

bool addAttachment(const mcap::Record& record, LogIndex& index) {
  mcap::Attachment attachment;
  if (!mcap::parse(record.content, attachment)) return false;
  index.attachments.push_back({std::move(attachment.name), std::move(attachment.media_type),
                               logTimeOf(attachment.log_time), attachment.data.size()});
  index.attachment_offsets.push_back(record.offset);
  return true;
}

bool addMetadata(const mcap::Record& record, LogIndex& index) {
  mcap::Metadata metadata;
  if (!mcap::parse(record.content, metadata)) return false;
  index.metadata.push_back({std::move(metadata.name), std::move(metadata.metadata)});
  return true;
}

}  // namespace rocinante
