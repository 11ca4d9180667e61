#include "core/log/log_index.h"

#include "core/mcap/parse_record.h"

namespace rocinante {

bool addChannel(std::map<ChannelId, LogChannel>& channels, const mcap::Channel& channel) {
  const auto [place, added] = channels.try_emplace(channel.id);
  LogChannel& known = place->second;
  if (!added) {
    return known.topic == channel.topic && known.encoding == channel.message_encoding &&
           known.metadata == channel.metadata;
  }
  known = {channel.id, channel.topic, channel.message_encoding, channel.metadata};
  return true;
}

bool addChannel(LogIndex& index, const mcap::Channel& channel) {
  if (!addChannel(index.channels, channel)) return false;
  if (channel.schema_id != 0) index.schema_ids.try_emplace(channel.id, channel.schema_id);
  return true;
}

void addSchema(LogIndex& index, mcap::Schema schema) {
  if (index.schemas.contains(schema.id)) return;
  index.schemas.emplace(
      schema.id, std::make_shared<const LogSchema>(LogSchema{
                     std::move(schema.name), std::move(schema.encoding), std::move(schema.data)}));
}

void joinSchemas(LogIndex& index) {
  for (const auto& [channel, schema] : index.schema_ids) {
    const auto found = index.schemas.find(schema);
    if (found != index.schemas.end()) index.channels.at(channel).schema = found->second;
  }
}

void addDamage(LogIndex& index, DamageSpan damage) {
  if (!index.damage.empty()) {
    DamageSpan& last = index.damage.back();
    if (damage.from < damage.to && last.to == damage.from && last.cause == damage.cause &&
        last.messages_lost.has_value() == damage.messages_lost.has_value()) {
      last.to = damage.to;
      if (damage.messages_lost) *last.messages_lost += *damage.messages_lost;
      return;
    }
  }
  index.damage.push_back(std::move(damage));
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
