#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/records.h"

namespace rocinante {

/// The part of an index that does not grow with the log's length.
struct IndexTables {
  mcap::Header header;
  std::map<ChannelId, LogChannel> channels;
  std::map<ChannelId, std::uint16_t> schema_ids;  ///< of channels that have one
  std::map<std::uint16_t, std::shared_ptr<const LogSchema>> schemas;
  std::map<ChannelId, std::uint64_t> message_counts;
  bool ended = false;   ///< its writer has ended the data: no message follows
  bool closed = false;  ///< the file ends with the Footer and the closing magic
};

/// The positions of everything in a log, from its summary or from a walk over the file.
struct LogIndex : IndexTables {
  std::vector<MessageSpan> spans;  ///< in the file's order
  std::vector<LogAttachment> attachments;
  std::vector<std::uint64_t> attachment_offsets;  ///< as `attachments`
  std::vector<LogMetadata> metadata;
  std::vector<DamageSpan> damage;
};

/// Lists a damage. Many small ones, one directly after the other, are listed as one.
void addDamage(LogIndex& index, DamageSpan damage);

/// Adds the record's contents; false when it breaks the format.
bool addAttachment(const mcap::Record& record, LogIndex& index);
bool addMetadata(const mcap::Record& record, LogIndex& index);

/// Adds a channel; false when its id is already used by a different one.
bool addChannel(std::map<ChannelId, LogChannel>& channels, const mcap::Channel& channel);
/// The same, and keeps the number of its schema.
bool addChannel(LogIndex& index, const mcap::Channel& channel);
/// Adds a schema; of two with one number the first counts.
void addSchema(LogIndex& index, mcap::Schema schema);
/// Gives every channel the schema that it names, as far as they are known.
void joinSchemas(LogIndex& index);

}  // namespace rocinante
