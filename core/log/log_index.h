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

/// The positions of everything in a log, from its summary or from a walk over the file.
struct LogIndex {
  mcap::Header header;
  std::vector<MessageSpan> spans;  ///< in the file's order
  std::map<ChannelId, LogChannel> channels;
  std::map<ChannelId, std::uint64_t> message_counts;
  std::vector<LogAttachment> attachments;
  std::vector<std::uint64_t> attachment_offsets;  ///< as `attachments`
  std::vector<LogMetadata> metadata;
  std::vector<DamageSpan> damage;
  bool closed = false;  ///< the file ends with the Footer and the closing magic
};

/// Adds the record's contents; false when it breaks the format.
bool addAttachment(const mcap::Record& record, LogIndex& index);
bool addMetadata(const mcap::Record& record, LogIndex& index);

/// Adds a channel; false when its id is already used by a different one.
bool addChannel(LogIndex& index, const mcap::Channel& channel);

}  // namespace rocinante
