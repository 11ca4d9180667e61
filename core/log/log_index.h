#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"
#include "core/mcap/records.h"
#include "core/mcap/stream_reader.h"

namespace rocinante {

/// Where everything in a log lies: what its summary says, or what a walk over the file found.
struct LogIndex {
  mcap::Header header;
  std::vector<MessageSpan> spans;  ///< in the file's order
  std::map<ChannelId, LogChannel> channels;
  std::map<ChannelId, std::uint64_t> message_counts;
  std::vector<LogAttachment> attachments;
  std::vector<std::uint64_t> attachment_offsets;  ///< as `attachments`
  std::vector<LogMetadata> metadata;
  std::vector<DamageSpan> damage;
  bool closed = false;  ///< ends as a whole file does
};

/// Adds what the record tells; false when it breaks the format.
bool addAttachment(const mcap::Record& record, LogIndex& index);
bool addMetadata(const mcap::Record& record, LogIndex& index);

/// Adds a channel; false when its id is there already and means another.
bool addChannel(LogIndex& index, const mcap::Channel& channel);

}  // namespace rocinante
