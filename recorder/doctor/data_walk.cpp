#include "recorder/doctor/data_walk.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

std::optional<std::uint64_t> DataWalk::run(const std::function<void(std::uint64_t)>& progress) {
  begin();
  while (!summary_start_) {
    const std::optional<mcap::Record> next = steps_.next();
    if (!next) {
      if (!skipBroken()) return std::nullopt;
      continue;
    }
    record(*next);
    last_offset_ = next->offset;
    if (progress) progress(steps_.position());
  }
  return summary_start_;
}

void DataWalk::begin() {
  const std::optional<mcap::Record> first = steps_.peek();
  mcap::Header header;
  if (!first || first->opcode != Opcode::header) {
    if (first || endsAsAWholeFile()) {
      report_.add("header", steps_.position(), "the first record is not a Header");
    }
  } else {
    steps_.moveTo(first->end());
    last_offset_ = first->offset;
    if (!mcap::parse(first->content, header)) {
      report_.add("record-fields", first->offset, "the lengths in the Header do not fit into it");
    }
    checkText(report_, first->offset, header.profile);
    checkText(report_, first->offset, header.library);
  }
  report_.profile = header.profile;
  facts_.ours = header.profile == profile::kName;
  if (facts_.ours) profile_.emplace(report_);
  chunks_.emplace(report_, facts_, definitions_, profile_ ? &*profile_ : nullptr, file_.size());
}

void DataWalk::record(const mcap::Record& record) {
  if (record.opcode == Opcode::message_index) return chunks_->index(record);
  chunks_->end();
  switch (record.opcode) {
    case Opcode::schema:
      definitions_.addSchema(record, record.offset);
      break;
    case Opcode::channel:
      if (const auto channel = definitions_.addChannel(record, record.offset);
          channel && profile_) {
        profile_->channel(*channel, record.offset);
      }
      break;
    case Opcode::message:
      if (facts_.loose_messages++ == 0) facts_.first_loose_offset = record.offset;
      if (profile_) {
        report_.add("loose-message", record.offset,
                    "a message is outside the chunks, where no checksum covers it");
      }
      chunks_->message(record, record.offset);
      break;
    case Opcode::chunk:
      chunks_->chunk(record);
      ++report_.chunks;
      break;
    case Opcode::attachment:
      attachment(record);
      break;
    case Opcode::metadata:
      metadata(record);
      break;
    case Opcode::data_end:
      dataEnd(record);
      break;
    case Opcode::invalid:
      report_.add("opcode", record.offset, "a record has opcode 0");
      break;
    case Opcode::header:
      report_.add("record-place", record.offset, "a second Header");
      break;
    case Opcode::message_index:
      break;
    case Opcode::footer:
    case Opcode::chunk_index:
    case Opcode::attachment_index:
    case Opcode::statistics:
    case Opcode::metadata_index:
    case Opcode::summary_offset:
      report_.add("data-end", record.offset,
                  fmt::format("a {} comes before any DataEnd", mcap::nameOf(record.opcode)));
      if (profile_) profile_->end(record.offset, last_offset_);
      summary_start_ = record.offset;
      break;
  }
}

void DataWalk::attachment(const mcap::Record& record) {
  facts_.attachment_offsets.push_back(record.offset);
  mcap::Attachment attachment;
  if (!mcap::parse(record.content, attachment)) {
    report_.add("record-fields", record.offset, "the lengths in an Attachment do not fit into it");
    return;
  }
  checkText(report_, record.offset, attachment.name);
  checkText(report_, record.offset, attachment.media_type);
  if (attachment.crc == 0) {
    if (profile_) report_.add("profile-crc", record.offset, "the attachment has no checksum");
  } else if (crc32(attachment.checked) != attachment.crc) {
    report_.add("attachment-crc", record.offset, "the attachment fails its checksum");
  }
}

void DataWalk::metadata(const mcap::Record& record) {
  facts_.metadata_offsets.push_back(record.offset);
  mcap::Metadata metadata;
  if (!mcap::parse(record.content, metadata)) {
    report_.add("record-fields", record.offset, "the lengths in a Metadata do not fit into it");
    return;
  }
  checkText(report_, record.offset, metadata.name);
  checkStringMap(report_, record.offset, record.content.subspan(4 + metadata.name.size()));
  if (profile_) profile_->metadata(metadata, record.offset);
}

void DataWalk::dataEnd(const mcap::Record& record) {
  mcap::DataEnd data_end;
  if (!mcap::parse(record.content, data_end)) {
    report_.add("record-fields", record.offset, "the DataEnd is not 4 bytes long");
  } else if (data_end.data_section_crc == 0) {
    if (profile_) report_.add("profile-crc", record.offset, "the data section has no checksum");
  } else {
    const std::uint32_t found = crc32(file_.first(static_cast<std::size_t>(record.offset)));
    if (found != data_end.data_section_crc) {
      report_.add("data-crc", record.offset,
                  fmt::format("the data section fails its checksum ({:08x}, stored {:08x})", found,
                              data_end.data_section_crc));
    }
  }
  if (profile_) profile_->end(record.offset, last_offset_);
  summary_start_ = record.end();
}

/// Describes how the file ends at the position, where a whole record is expected.
std::string DataWalk::cutOff() const {
  if (steps_.atEnd()) return "the file ends before its DataEnd";
  const std::optional<ChunkHead> chunk = chunkHeadAt(file_, steps_.position());
  if (chunk && chunk->open()) {
    return fmt::format("the chunk that begins here is still open, {} bytes before the file's end",
                       file_.size() - steps_.position());
  }
  return fmt::format("the file ends inside the record that begins here, after {} bytes of it",
                     file_.size() - steps_.position());
}

bool DataWalk::endsAsAWholeFile() const {
  if (file_.size() < mcap::magic().size() + mcap::kFileEndBytes) return false;
  const std::optional<mcap::Record> footer =
      mcap::recordAt(file_, file_.size() - mcap::kFileEndBytes);
  return footer && footer->opcode == Opcode::footer &&
         footer->content.size() == mcap::kFooterContentBytes &&
         std::ranges::equal(file_.last(mcap::magic().size()), mcap::magic());
}

/// Skips to the next record when there is none at the position; false when the file was never
/// closed.
bool DataWalk::skipBroken() {
  chunks_->end();
  if (!endsAsAWholeFile()) {
    report_.add("not-closed", steps_.position(), cutOff() + ": it was never closed");
    return false;
  }
  const std::uint64_t from = steps_.position();
  steps_.moveTo(probe_.resumeBehind(from));
  report_.add("record-length", from,
              fmt::format("a record reaches past the end of the file; {} bytes were passed over",
                          steps_.position() - from));
  facts_.all_read = false;
  if (profile_) profile_->gap();
  if (!steps_.atEnd()) return true;
  report_.add("data-end", from, "no DataEnd follows");
  return false;
}

}  // namespace rocinante
