#include "recorder/doctor/summary_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

namespace {

constexpr std::size_t kMaxGroups = 64;  ///< bounds the memory for a hostile file

}  // namespace

void SummaryRules::run(std::uint64_t start) {
  start_ = start;
  chunks_seen_.resize(facts_.chunk_offsets.size());
  attachments_seen_.resize(facts_.attachment_offsets.size());
  metadata_seen_.resize(facts_.metadata_offsets.size());
  mcap::RecordStepper steps(file_, start);
  while (const std::optional<mcap::Record> next = steps.next()) {
    if (next->opcode == Opcode::footer) return footer(*next);
    record(*next);
  }
  report_.add("not-closed", steps.position(),
              "the file ends inside its summary: it was never closed");
}

void SummaryRules::record(const mcap::Record& record) {
  place(record);
  switch (record.opcode) {
    case Opcode::schema:
      definitions_.addSchema(record, record.offset);
      break;
    case Opcode::channel:
      if (const auto channel = definitions_.addChannel(record, record.offset)) {
        any_channel_ = true;
        channels_repeated_.insert(channel->id);
      }
      break;
    case Opcode::chunk_index:
      chunkIndex(record);
      break;
    case Opcode::attachment_index:
      attachmentIndex(record);
      break;
    case Opcode::metadata_index:
      metadataIndex(record);
      break;
    case Opcode::statistics:
      statistics(record);
      break;
    case Opcode::summary_offset:
      summaryOffset(record);
      break;
    case Opcode::invalid:
      report_.add("opcode", record.offset, "a record has opcode 0");
      break;
    case Opcode::header:
    case Opcode::message:
    case Opcode::chunk:
    case Opcode::message_index:
    case Opcode::attachment:
    case Opcode::metadata:
    case Opcode::data_end:
      report_.add("record-place", record.offset,
                  fmt::format("a {} comes after DataEnd", mcap::nameOf(record.opcode)));
      break;
    case Opcode::footer:
      break;
  }
}

void SummaryRules::place(const mcap::Record& record) {
  if (!groups_.empty() && groups_.back().opcode == record.opcode) {
    groups_.back().end = record.end();
    return;
  }
  const bool again = std::ranges::any_of(
      groups_, [&](const Group& group) { return group.opcode == record.opcode; });
  if (again) {
    report_.add("summary-group", record.offset,
                fmt::format("{} records are not contiguous", mcap::nameOf(record.opcode)));
  }
  if (!groups_.empty() && groups_.back().opcode == Opcode::summary_offset) {
    report_.add("summary-group", record.offset,
                fmt::format("a {} comes after the SummaryOffsets", mcap::nameOf(record.opcode)));
  }
  if (groups_.size() < kMaxGroups) {
    groups_.push_back({record.opcode, record.offset, record.end(), false});
  }
}

bool SummaryRules::point(const std::vector<std::uint64_t>& offsets, std::vector<bool>& seen,
                         std::uint64_t pointed, std::uint64_t offset, std::string_view rule) {
  const auto found = std::ranges::lower_bound(offsets, pointed);
  if (found == offsets.end() || *found != pointed) {
    report_.add(rule, offset,
                fmt::format("it points at byte {}, which is not such a record", pointed));
    return false;
  }
  const auto at = static_cast<std::size_t>(found - offsets.begin());
  if (seen[at]) {
    report_.add(rule, offset, fmt::format("a second index of the record at byte {}", pointed));
    return false;
  }
  seen[at] = true;
  return true;
}

void SummaryRules::chunkIndex(const mcap::Record& record) {
  any_chunk_index_ = true;
  mcap::ChunkIndex index;
  if (!mcap::parse(record.content, index)) {
    report_.add("record-fields", record.offset, "the lengths in a ChunkIndex do not fit into it");
    return;
  }
  checkNumberMap(report_, record.offset, record.content.subspan(32));
  if (point(facts_.chunk_offsets, chunks_seen_, index.chunk_start_offset, record.offset,
            "chunk-index")) {
    compareWithChunk(index, record);
  }
}

void SummaryRules::compareWithChunk(const mcap::ChunkIndex& index, const mcap::Record& record) {
  const std::optional<mcap::Record> chunk_record = mcap::recordAt(file_, index.chunk_start_offset);
  mcap::Chunk chunk;
  if (!chunk_record || !mcap::parse(chunk_record->content, chunk)) return;
  const auto differs = [&](bool same, std::string_view field) {
    if (same) return;
    report_.add("chunk-index", record.offset,
                fmt::format("its {} differs from that of the chunk at byte {}", field,
                            index.chunk_start_offset));
  };
  differs(index.chunk_length == mcap::kPrefixBytes + chunk_record->content.size(), "chunk_length");
  differs(index.message_start_time == chunk.message_start_time, "message_start_time");
  differs(index.message_end_time == chunk.message_end_time, "message_end_time");
  differs(index.compression == chunk.compression, "compression");
  differs(index.compressed_size == chunk.records.size(), "compressed_size");
  differs(index.uncompressed_size == chunk.uncompressed_size, "uncompressed_size");

  std::map<std::uint16_t, std::uint64_t> offsets;
  std::uint64_t position = chunk_record->end();
  while (const auto next = mcap::recordAt(file_, position)) {
    mcap::ByteCursor cursor(next->content);
    const auto channel = cursor.number<std::uint16_t>();
    if (next->opcode != Opcode::message_index || !cursor.ok()) break;
    offsets.emplace(channel, next->offset);
    position = next->end();
  }
  differs(index.message_index_length == position - chunk_record->end(), "message_index_length");
  // Other writers may leave the map empty; ours may not.
  if (!index.message_index_offsets.empty() || facts_.ours) {
    differs(index.message_index_offsets == offsets, "message_index_offsets");
  }
}

void SummaryRules::attachmentIndex(const mcap::Record& record) {
  any_attachment_index_ = true;
  mcap::AttachmentIndex index;
  if (!mcap::parse(record.content, index)) {
    report_.add("record-fields", record.offset,
                "the lengths in an AttachmentIndex do not fit into it");
    return;
  }
  if (!point(facts_.attachment_offsets, attachments_seen_, index.offset, record.offset,
             "attachment-index")) {
    return;
  }
  const std::optional<mcap::Record> pointed = mcap::recordAt(file_, index.offset);
  mcap::Attachment attachment;
  if (!pointed || !mcap::parse(pointed->content, attachment)) return;
  const bool same = index.length == mcap::kPrefixBytes + pointed->content.size() &&
                    index.log_time == attachment.log_time &&
                    index.create_time == attachment.create_time &&
                    index.data_size == attachment.data.size() && index.name == attachment.name &&
                    index.media_type == attachment.media_type;
  if (same) return;
  report_.add("attachment-index", record.offset,
              fmt::format("it does not match the attachment at byte {}", index.offset));
}

void SummaryRules::metadataIndex(const mcap::Record& record) {
  any_metadata_index_ = true;
  mcap::MetadataIndex index;
  if (!mcap::parse(record.content, index)) {
    report_.add("record-fields", record.offset,
                "the lengths in a MetadataIndex do not fit into it");
    return;
  }
  if (!point(facts_.metadata_offsets, metadata_seen_, index.offset, record.offset,
             "metadata-index")) {
    return;
  }
  const std::optional<mcap::Record> pointed = mcap::recordAt(file_, index.offset);
  mcap::Metadata metadata;
  if (!pointed || !mcap::parse(pointed->content, metadata)) return;
  if (index.length == mcap::kPrefixBytes + pointed->content.size() && index.name == metadata.name) {
    return;
  }
  report_.add("metadata-index", record.offset,
              fmt::format("it does not match the metadata at byte {}", index.offset));
}

void SummaryRules::statistics(const mcap::Record& record) {
  if (statistics_) {
    report_.add("statistics", record.offset, "a second Statistics");
    return;
  }
  statistics_ = record;
}

void SummaryRules::compareStatistics() {
  const std::uint64_t offset = statistics_->offset;
  mcap::Statistics stated;
  if (!mcap::parse(statistics_->content, stated)) {
    report_.add("record-fields", offset, "the lengths in the Statistics do not fit into it");
    return;
  }
  checkNumberMap(report_, offset, statistics_->content.subspan(42));
  const auto differs = [&](std::uint64_t value, std::uint64_t is, std::string_view field) {
    if (value == is) return;
    report_.add("statistics", offset,
                fmt::format("{}: the file has {}, Statistics says {}", field, is, value));
  };
  differs(stated.schema_count, definitions_.schemas(), "schema_count");
  differs(stated.channel_count, definitions_.channels(), "channel_count");
  differs(stated.attachment_count, facts_.attachment_offsets.size(), "attachment_count");
  differs(stated.metadata_count, facts_.metadata_offsets.size(), "metadata_count");
  differs(stated.chunk_count, facts_.chunk_offsets.size(), "chunk_count");
  // The messages of a broken chunk are unknown.
  if (!facts_.all_read) return;
  const bool any = facts_.message_count > 0;
  differs(stated.message_count, facts_.message_count, "message_count");
  differs(stated.message_start_time, any ? facts_.start_time : 0, "message_start_time");
  differs(stated.message_end_time, any ? facts_.end_time : 0, "message_end_time");
  // Other writers may leave the map empty; ours may not.
  if (stated.channel_message_counts.empty() && !facts_.ours) return;
  for (const auto& [channel, count] : facts_.messages) {
    const auto found = stated.channel_message_counts.find(channel);
    differs(found == stated.channel_message_counts.end() ? 0 : found->second, count,
            fmt::format("the count of channel {}", channel));
  }
  for (const auto& [channel, count] : stated.channel_message_counts) {
    if (!facts_.messages.contains(channel)) {
      differs(count, 0, fmt::format("the count of channel {}", channel));
    }
  }
}

void SummaryRules::summaryOffset(const mcap::Record& record) {
  mcap::SummaryOffset offset;
  if (!mcap::parse(record.content, offset)) {
    report_.add("record-fields", record.offset,
                "the lengths in a SummaryOffset do not fit into it");
    return;
  }
  const auto group = std::ranges::find_if(groups_, [&](const Group& each) {
    return each.opcode == offset.group_opcode && each.opcode != Opcode::summary_offset;
  });
  const std::string_view kind = mcap::nameOf(offset.group_opcode);
  if (group == groups_.end()) {
    report_.add("summary-offset", record.offset,
                fmt::format("it points at {} records, but there are none", kind));
  } else if (group->pointed_at) {
    report_.add("summary-offset", record.offset,
                fmt::format("a second SummaryOffset for {} records", kind));
  } else if (group->start != offset.group_start ||
             group->end - group->start != offset.group_length) {
    report_.add("summary-offset", record.offset,
                fmt::format("{} records are at bytes {} to {}, not where it says", kind,
                            group->start, group->end));
    group->pointed_at = true;
  } else {
    group->pointed_at = true;
  }
}

void SummaryRules::footer(const mcap::Record& record) {
  complete(record.offset);
  mcap::Footer footer;
  if (!mcap::parse(record.content, footer)) {
    report_.add("record-fields", record.offset, "the Footer is not 20 bytes long");
  } else {
    const auto offsets = std::ranges::find(groups_, Opcode::summary_offset, &Group::opcode);
    const std::uint64_t summary_start = groups_.empty() ? 0 : groups_.front().start;
    const std::uint64_t offset_start = offsets == groups_.end() ? 0 : offsets->start;
    if (footer.summary_start != summary_start) {
      report_.add(
          "footer", record.offset,
          fmt::format("summary_start is {} and should be {}", footer.summary_start, summary_start));
    }
    if (footer.summary_offset_start != offset_start) {
      report_.add("footer", record.offset,
                  fmt::format("summary_offset_start is {} and should be {}",
                              footer.summary_offset_start, offset_start));
    }
    const std::uint64_t from = groups_.empty() ? record.offset : summary_start;
    const std::uint64_t to = record.offset + mcap::kPrefixBytes + 16;
    const std::uint32_t found =
        crc32(file_.subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)));
    if (footer.summary_crc == 0) {
      if (facts_.ours) report_.add("profile-crc", record.offset, "the summary has no checksum");
    } else if (footer.summary_crc != found) {
      report_.add("summary-crc", record.offset,
                  fmt::format("the summary fails its checksum ({:08x}, stored {:08x})", found,
                              footer.summary_crc));
    }
  }
  const ByteView behind = file_.subspan(static_cast<std::size_t>(record.end()));
  const std::size_t magic_bytes = mcap::magic().size();
  if (behind.size() < magic_bytes) {
    report_.add("not-closed", record.end(), "the file ends inside its closing magic");
  } else if (!std::ranges::equal(behind.first(magic_bytes), mcap::magic())) {
    report_.add("magic", record.end(), "no magic follows the Footer");
  } else if (behind.size() > magic_bytes) {
    report_.add("trailing-bytes", record.end() + magic_bytes,
                fmt::format("{} bytes follow the closing magic", behind.size() - magic_bytes));
  }
}

void SummaryRules::missing(const std::vector<std::uint64_t>& offsets, const std::vector<bool>& seen,
                           bool required, std::string_view rule, std::string_view what) {
  if (!required) return;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (!seen[i])
      report_.add(rule, offsets[i], fmt::format("the summary has no index of {}", what));
  }
}

/// Checks that nothing required is missing.
void SummaryRules::complete(std::uint64_t offset) {
  missing(facts_.chunk_offsets, chunks_seen_, facts_.ours || any_chunk_index_, "chunk-index",
          "this chunk");
  missing(facts_.attachment_offsets, attachments_seen_, facts_.ours || any_attachment_index_,
          "attachment-index", "this attachment");
  missing(facts_.metadata_offsets, metadata_seen_, facts_.ours || any_metadata_index_,
          "metadata-index", "this metadata");
  if (any_chunk_index_ && !facts_.ours && facts_.loose_messages > 0) {
    report_.add("loose-message", facts_.first_loose_offset,
                countText(facts_.loose_messages, "message") + " outside the indexed chunks");
  }
  if (facts_.ours || (any_chunk_index_ && any_channel_)) {
    for (const auto& [channel, count] : facts_.messages) {
      if (definitions_.hasChannel(channel) && !channels_repeated_.contains(channel)) {
        report_.add("summary-channel", start_,
                    fmt::format("channel {} has messages but is not in the summary", channel));
      }
    }
  }
  if (statistics_) {
    compareStatistics();
  } else if (facts_.ours) {
    report_.add("statistics", offset, "the summary has no Statistics");
  }
  const auto channels = std::ranges::find(groups_, Opcode::channel, &Group::opcode);
  if (statistics_ && channels != groups_.end() && channels->start > statistics_->offset) {
    report_.add("statistics", statistics_->offset, "the Statistics come before the channels");
  }
  for (const Group& group : groups_) {
    if (!facts_.ours || group.pointed_at || group.opcode == Opcode::summary_offset) continue;
    report_.add(
        "summary-offset", group.start,
        fmt::format("no SummaryOffset points at the {} records", mcap::nameOf(group.opcode)));
  }
}

}  // namespace rocinante
