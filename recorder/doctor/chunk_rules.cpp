#include "recorder/doctor/chunk_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

void ChunkRules::chunk(const mcap::Record& record) {
  open_ = true;
  readable_ = false;
  offset_ = record.offset;
  entries_.clear();
  any_index_ = false;
  facts_.chunk_offsets.push_back(record.offset);
  mcap::Chunk chunk;
  if (!mcap::parse(record.content, chunk)) {
    report_.add("record-fields", offset_, "the lengths in a Chunk do not fit into it");
    return unreadable();
  }
  if (profile_ != nullptr && chunk.compression != "" && chunk.compression != "zstd") {
    report_.add("profile-compression", offset_,
                "a chunk of this profile is compressed with zstd or not at all");
    return unreadable();
  }
  if (!budget_.take(chunk)) {
    report_.add("chunk-unread", offset_,
                fmt::format("it was not expanded: the chunks up to it claim more than {} bytes "
                            "and {} times the file's size",
                            mcap::ExpansionBudget::kFreeBytes, mcap::ExpansionBudget::kMaxGrowth));
    return unreadable();
  }
  // The checksum is checked separately from the content.
  mcap::Chunk unchecked = chunk;
  unchecked.uncompressed_crc = 0;
  const Result<ByteView> expanded = expander_.expand(unchecked, scratch_);
  if (!expanded) {
    report_.add(expanded.error().kind == ErrorKind::unsupported ? "chunk-unread" : "chunk-content",
                offset_, expanded.error().what);
    return unreadable();
  }
  if (chunk.uncompressed_crc == 0) {
    if (profile_ != nullptr && !expanded->empty()) {
      report_.add("profile-crc", offset_, "the chunk has no checksum");
    }
  } else if (const std::uint32_t found = crc32(*expanded); found != chunk.uncompressed_crc) {
    report_.add("chunk-crc", offset_,
                fmt::format("the chunk fails its checksum ({:08x}, stored {:08x})", found,
                            chunk.uncompressed_crc));
    // Its contents cannot be trusted.
    return unreadable();
  }
  readable_ = true;
  records(chunk, *expanded);
}

void ChunkRules::unreadable() {
  readable_ = false;
  facts_.all_read = false;
  if (profile_ != nullptr) profile_->gap();
}

void ChunkRules::records(const mcap::Chunk& chunk, ByteView records) {
  mcap::RecordStepper steps(records);
  while (const std::optional<mcap::Record> record = steps.next()) {
    if (record->opcode == Opcode::message) {
      message(*record, offset_);
    } else if (record->opcode == Opcode::schema) {
      definitions_.addSchema(*record, offset_);
    } else if (record->opcode == Opcode::channel) {
      if (const std::optional<mcap::Channel> channel = definitions_.addChannel(*record, offset_)) {
        defined_in_[channel->id] = number();
        if (profile_ != nullptr) profile_->channel(*channel, offset_);
      }
    } else if (record->opcode <= Opcode::data_end) {
      report_.add("chunk-records", offset_,
                  fmt::format("a {} is inside a chunk", mcap::nameOf(record->opcode)));
    }
  }
  if (!steps.atEnd()) {
    report_.add("chunk-records", offset_,
                fmt::format("a record reaches past the end of its chunk, {} bytes into it",
                            steps.position()));
    return unreadable();
  }
  times(chunk);
}

void ChunkRules::message(const mcap::Record& record, std::uint64_t offset) {
  mcap::Message message;
  if (!mcap::parse(record.content, message)) {
    report_.add("record-fields", offset, "a Message is too short");
    return;
  }
  ++report_.messages;
  ++facts_.message_count;
  ++facts_.messages[message.channel_id];
  facts_.start_time = std::min(facts_.start_time, message.log_time);
  facts_.end_time = std::max(facts_.end_time, message.log_time);
  if (open_) entries_.push_back({message.channel_id, message.log_time, record.offset});
  if (!definitions_.hasChannel(message.channel_id)) {
    report_.add(
        "message-channel", offset,
        fmt::format("a message on channel {}, which was not defined before", message.channel_id));
    return;
  }
  if (profile_ == nullptr) return;
  if (open_ && defined_in_[message.channel_id] != number()) {
    report_.add(
        "chunk-alone", offset,
        fmt::format("channel {} is used in a chunk that does not define it", message.channel_id));
    defined_in_[message.channel_id] = number();  // reported once per chunk
  }
  profile_->message(message, offset);
}

void ChunkRules::times(const mcap::Chunk& chunk) {
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  for (bool first = true; const Entry& entry : entries_) {
    start = first ? entry.time : std::min(start, entry.time);
    end = std::max(end, entry.time);
    first = false;
  }
  if (chunk.message_start_time == start && chunk.message_end_time == end) return;
  report_.add("chunk-times", offset_,
              fmt::format("the header gives the times {} to {}, the messages {} to {}",
                          chunk.message_start_time, chunk.message_end_time, start, end));
}

void ChunkRules::index(const mcap::Record& record) {
  if (!open_) {
    report_.add("record-place", record.offset, "a MessageIndex does not follow a chunk");
    return;
  }
  mcap::MessageIndex index;
  if (!mcap::parse(record.content, index)) {
    report_.add("record-fields", record.offset, "the lengths in a MessageIndex do not fit into it");
    return;
  }
  if (indexed_in_[index.channel_id] == number()) {
    report_.add("index-twice", record.offset,
                fmt::format("a second MessageIndex of channel {}", index.channel_id));
    return;
  }
  // Sorted to compare them channel by channel.
  if (!any_index_) std::ranges::sort(entries_);
  any_index_ = true;
  indexed_in_[index.channel_id] = number();
  if (index.records.empty()) {
    report_.add("index-empty", record.offset,
                fmt::format("the MessageIndex of channel {} is empty", index.channel_id));
    return;
  }
  if (!readable_) return;
  std::ranges::sort(index.records);
  const auto first = std::ranges::lower_bound(entries_, index.channel_id, {}, &Entry::channel);
  const auto last = std::ranges::upper_bound(entries_, index.channel_id, {}, &Entry::channel);
  const bool same = std::equal(index.records.begin(), index.records.end(), first, last,
                               [](const auto& stated, const Entry& is) {
                                 return stated.first == is.time && stated.second == is.offset;
                               });
  if (same) return;
  report_.add("index-entries", record.offset,
              fmt::format("the MessageIndex of channel {} does not list its {} in the chunk",
                          index.channel_id,
                          countText(static_cast<std::uint64_t>(last - first), "message")));
}

void ChunkRules::end() {
  if (!open_) return;
  open_ = false;
  if (!readable_ || (!any_index_ && profile_ == nullptr)) return;
  std::ranges::sort(entries_);
  for (auto at = entries_.begin(); at != entries_.end();) {
    const std::uint16_t channel = at->channel;
    if (indexed_in_[channel] != number()) {
      report_.add("index-missing", offset_,
                  fmt::format("channel {} has messages in the chunk but no MessageIndex after it",
                              channel));
    }
    at = std::find_if(at, entries_.end(),
                      [&](const Entry& entry) { return entry.channel != channel; });
  }
}

}  // namespace rocinante
