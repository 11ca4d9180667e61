#include "core/log/log_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/hash.h"
#include "core/log/captured_range.h"
#include "core/log/file_order.h"
#include "core/log/foreign_file.h"
#include "core/log/growing_index.h"
#include "core/log/last_message.h"
#include "core/log/log_end.h"
#include "core/log/log_index_summary.h"
#include "core/log/log_index_walk.h"
#include "core/log/log_profile.h"
#include "core/log/mapped_file.h"
#include "core/log/other_format.h"
#include "core/log/recorded_losses.h"
#include "core/log/span_damage.h"
#include "core/log/span_merge.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {
namespace {

constexpr LogTime kFirstMoment{Nanoseconds(std::numeric_limits<std::int64_t>::min())};

/// The value that metadata `name` gives for `key`, or null.
const std::string* metadataValue(const std::vector<LogMetadata>& metadata, std::string_view name,
                                 std::string_view key) {
  for (const LogMetadata& record : metadata) {
    if (record.name != name) continue;
    const auto found = record.entries.find(std::string(key));
    if (found != record.entries.end()) return &found->second;
  }
  return nullptr;
}

std::optional<LogTime> originIn(const std::vector<LogMetadata>& metadata, std::string_view name) {
  const std::string* const text = metadataValue(metadata, name, profile::kOriginKey);
  return text == nullptr ? std::nullopt : profile::parseOrigin(*text);
}

}  // namespace

struct LogReader::Impl {
  MappedFile mapped;
  bool is_mapped = false;               ///< otherwise the bytes are in memory
  std::optional<GrowingIndex> growing;  ///< until the log is closed
  bool being_written = false;
  bool followed = false;          ///< being_written until it is closed
  std::size_t settled_spans = 0;  ///< they stay as they are when the log grows
  ByteView file;
  std::string name;
  LogIndex index;
  std::vector<DamageSpan> summary_damage;  ///< of one that was there when the log was opened
  std::vector<DamageSpan> damage;          ///< that, that of `index`, then what reading found
  std::size_t walked_damage = 0;           ///< how many are not from reading
  std::uint64_t needed_bytes = 0;          ///< of the file: those behind held no message yet
  std::uint64_t needed_for = 0;            ///< the messages that they hold
  std::vector<LogChannel> channels;
  std::vector<const LogChannel*> channel_by_id;
  LogSummary summary;
  std::optional<std::vector<LossSpan>> losses;  ///< found on the first call
  std::vector<UnreadableRange> unreadable;
  std::size_t ranged =
      0;  ///< damages examined so far; those that cost messages are in `unreadable`
  std::optional<bool> is_ordered;  ///< areInOrder(), found when there is damage
  CapturedRange settled_range;     ///< of the first `ranged_spans`
  std::size_t ranged_spans = 0;
  std::optional<SpanCache> cache;
  std::optional<SpanMerge> merge;
  std::optional<FileOrder> in_file;
  std::optional<LastMessage> last;  ///< made on the first call

  Status checkMagic() const {
    const bool begins = followed && file.size() < mcap::magic().size() &&
                        std::ranges::equal(file, mcap::magic().first(file.size()));
    if (begins || magicAt(file, 0)) return {};
    return Error{ErrorKind::damaged, notALog(file), name};
  }

  bool isBeingWritten() const { return followed || mapped.beingWritten(); }

  Status build(bool may_grow = false) {
    if (Status known = checkMagic(); !known) return known;
    if (std::optional<LogIndex> found = indexFromSummary(file, summary_damage)) {
      index = std::move(*found);
    } else if (may_grow) {
      growing.emplace();
      being_written = isBeingWritten();
      walkOn();
    } else {
      index = indexByWalking(file, is_mapped ? &mapped : nullptr);
    }
    damage = summary_damage;
    useIndex();
    return {};
  }

  void useIndex() {
    findSchemas();
    channels.clear();
    channel_by_id.clear();
    for (const auto& [id, channel] : index.channels) channels.push_back(channel);
    for (const LogChannel& channel : channels) {
      if (channel_by_id.size() <= channel.id) channel_by_id.resize(channel.id + 1U, nullptr);
      channel_by_id[channel.id] = &channel;
    }
    if (cache) {
      cache->fileGrew(file, settled_spans);
      merge->fileGrew(settled_spans);
      in_file->fileGrew(settled_spans);
    } else {
      cache.emplace(file, is_mapped ? &mapped : nullptr, index.spans, channel_by_id, damage);
      merge.emplace(*cache);
      in_file.emplace(*cache);
    }
    damage.insert(damage.end(), index.damage.begin(), index.damage.end());
    summarise();
  }

  /// Brings the index to the file as it is now.
  void walkOn() {
    growing->update(mapped, being_written, index);
    std::uint64_t messages = 0;
    for (const auto& [channel, count] : index.message_counts) messages += count;
    if (messages > needed_for) needed_bytes = file.size();
    needed_for = messages;
    const std::uint64_t file_bytes = file.size();
    needed_bytes = std::max(needed_bytes, std::min(growing->settledBytes(), file_bytes));
  }

  Result<bool> refresh() {
    if (!growing) return false;
    if (followed && mapped.replaced()) {
      return Error{ErrorKind::unreadable, "another file replaced the one that is followed", name};
    }
    // First: what a writer that is gone has written is in the file.
    const bool written = isBeingWritten();
    const Result<bool> grown = mapped.grow(needed_bytes);
    if (!grown) return grown.error();
    if (!*grown && written == being_written) return false;
    being_written = written;
    // The chunk whose indexes may still come is behind no settled record yet, and is read again.
    const std::uint64_t settled_bytes = settled_spans < index.spans.size()
                                            ? index.spans[settled_spans].offset
                                            : growing->settledBytes();
    std::vector<DamageSpan> found(damage.begin() + static_cast<std::ptrdiff_t>(walked_damage),
                                  damage.end());
    std::erase_if(found, [&](const DamageSpan& each) { return each.from >= settled_bytes; });
    damage = summary_damage;
    file = mapped.bytes();
    if (Status known = checkMagic(); !known) return known.error();
    walkOn();
    summary = {};
    losses.reset();
    unreadable.clear();
    ranged = 0;
    is_ordered.reset();
    last.reset();
    useIndex();
    damage.insert(damage.end(), found.begin(), found.end());
    settled_spans = growing->settledSpans();
    if (index.closed) growing.reset();
    return true;
  }

  /// A summary need not repeat the schemas: then they are in the chunks, before their channels.
  void findSchemas() {
    SpanDecoder decoder(file, is_mapped ? &mapped : nullptr);
    SpanMessages messages;
    for (const auto& [channel, schema_id] : index.schema_ids) {
      if (index.schemas.contains(schema_id)) continue;
      const auto holds = [&, id = channel](const MessageSpan& span) {
        return !span.loose && !span.over_budget && span.mayHold(id);
      };
      const auto span = std::ranges::find_if(index.spans, holds);
      if (span == index.spans.end()) continue;
      decoder.decode(*span, messages);
      for (const ByteView content : messages.schemas) {
        mcap::Schema schema;
        if (mcap::parse(content, schema)) addSchema(index, std::move(schema));
      }
    }
    joinSchemas(index);
  }

  void summarise() {
    const std::string* const reason =
        metadataValue(index.metadata, profile::kEnd, profile::kReasonKey);
    if (reason != nullptr) summary.end_reason = *reason;
    summary.profile = index.header.profile;
    summary.library = index.header.library;
    summary.closed = index.closed;
    summary.complete = index.closed && (reason != nullptr || !isOurs());
    lookAtFormat();
    if (const std::string* id =
            metadataValue(index.metadata, profile::kSession, profile::kSessionIdKey)) {
      summary.session_id = *id;
    }
    bool others = false;
    for (const LogChannel& channel : channels) {
      const auto count = index.message_counts.find(channel.id);
      if (count == index.message_counts.end() || count->second == 0) continue;
      if (channel.captured()) {
        summary.messages += count->second;
      } else {
        others = true;
      }
    }
    const std::optional<LogTime> origin = originIn(index.metadata, profile::kSession);
    const std::optional<LogTime> origin_again = originIn(index.metadata, profile::kEnd);
    if (origin && origin_again && *origin != *origin_again) {
      damage.push_back({0, file.size(),
                        "rocinante.session and rocinante.end give different origins; the "
                        "first is used",
                        std::uint64_t{0}});
    }
    walked_damage = damage.size();
    if (summary.messages > 0) {
      const std::size_t settled = growing ? growing->settledSpans() : 0;
      widen(settled_range, *cache, ranged_spans, settled, others);
      ranged_spans = settled;
      CapturedRange range = settled_range;
      widen(range, *cache, settled, index.spans.size(), others);
      if (range.start <= range.end) {
        summary.start = range.start;
        summary.end = range.end;
      }
    }
    summary.origin = origin ? *origin : origin_again ? *origin_again : summary.start;
    if (summary.messages == 0) summary.start = summary.end = summary.origin;
  }

  bool isOurs() const { return index.header.profile == profile::kName; }

  /// An unknown format may give any meaning to the records here.
  void lookAtFormat() {
    for (const LogMetadata& record : index.metadata) {
      if (record.name != profile::kSession) continue;
      const auto format = record.entries.find(std::string(profile::kFormatKey));
      summary.format = format == record.entries.end() ? std::string() : format->second;
      if (summary.format == profile::kFormat) return;
      damage.push_back(
          {0, file.size(), profile::otherFormatText(summary.format), std::uint64_t{0}});
      noteOtherFormat(summary.format, name);
      return;
    }
  }

  const MessageSpan& spanAt(std::uint32_t i) const { return index.spans[i]; }

  void findUnreadable() {
    if (ranged == damage.size()) return;
    if (!is_ordered) is_ordered = areInOrder(index.spans);
    for (; ranged < damage.size(); ++ranged) {
      std::optional<UnreadableRange> range =
          unreadableRange(damage[ranged], index.spans, *is_ordered, file.size());
      if (!range) continue;
      range->damage = ranged;
      unreadable.push_back(*range);
    }
  }
};

Result<LogReader> LogReader::openMapped(Result<MappedFile> mapped, std::string name,
                                        Growth growth) {
  if (!mapped) return mapped.error();
  auto impl = std::make_unique<Impl>();
  impl->mapped = std::move(*mapped);
  impl->is_mapped = true;
  impl->file = impl->mapped.bytes();
  impl->name = std::move(name);
  impl->followed = growth == Growth::to_the_end;
  if (Status built = impl->build(growth != Growth::none); !built) return built.error();
  if (impl->growing) impl->settled_spans = impl->growing->settledSpans();
  return LogReader(std::move(impl));
}

Result<LogReader> LogReader::open(const std::filesystem::path& path) {
  return openMapped(MappedFile::open(path), path.string(), Growth::none);
}

Result<LogReader> LogReader::openGrowing(const std::filesystem::path& path) {
  return openMapped(MappedFile::openGrowing(path), path.string(), Growth::while_locked);
}

Result<LogReader> LogReader::follow(const std::filesystem::path& path) {
  return openMapped(MappedFile::openGrowing(path), path.string(), Growth::to_the_end);
}

Result<LogReader> LogReader::openBytes(ByteView bytes, std::string name) {
  auto impl = std::make_unique<Impl>();
  impl->file = bytes;
  impl->name = std::move(name);
  if (Status built = impl->build(); !built) return built.error();
  return LogReader(std::move(impl));
}

LogReader::LogReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LogReader::~LogReader() = default;
LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;

Result<bool> LogReader::refresh() { return impl_->refresh(); }
bool LogReader::growing() const { return impl_->growing && impl_->being_written; }
bool LogReader::ended() const { return impl_->index.ended || impl_->index.closed; }
const LogSummary& LogReader::summary() const { return impl_->summary; }
const std::vector<LogChannel>& LogReader::channels() const { return impl_->channels; }
const std::vector<LogMetadata>& LogReader::metadata() const { return impl_->index.metadata; }
const std::vector<LogAttachment>& LogReader::attachments() const {
  return impl_->index.attachments;
}
const std::vector<LossSpan>& LogReader::losses() const {
  if (!impl_->losses) impl_->losses = recordedLosses(*impl_->cache, impl_->index.message_counts);
  return *impl_->losses;
}
const std::vector<DamageSpan>& LogReader::damage() const { return impl_->damage; }
const std::vector<UnreadableRange>& LogReader::unreadable() const {
  impl_->findUnreadable();
  return impl_->unreadable;
}
const std::string& LogReader::name() const { return impl_->name; }

LogStorage LogReader::storage() const {
  LogStorage storage;
  storage.file_bytes = impl_->file.size();
  std::set<std::string> compressions;
  for (const MessageSpan& span : impl_->index.spans) {
    compressions.insert(span.chunk.compression.empty() ? "none"
                                                       : std::string(span.chunk.compression));
    if (span.loose) continue;
    ++storage.chunks;
    storage.stored_bytes += span.chunk.records.size();
    storage.expanded_bytes += span.chunk.uncompressed_size;
  }
  storage.compressions.assign(compressions.begin(), compressions.end());
  return storage;
}

Result<Bytes> LogReader::readAttachment(std::size_t index) const {
  if (index >= impl_->index.attachments.size()) {
    return Error{ErrorKind::not_found, fmt::format("there is no attachment {}", index), name()};
  }
  const std::uint64_t offset = impl_->index.attachment_offsets[index];
  const std::string place = fmt::format("{}, byte {}", name(), offset);
  if (impl_->is_mapped && !impl_->mapped.whole()) {
    return Error{ErrorKind::unreadable, "the file was truncated while it was read", place};
  }
  const std::optional<mcap::Record> record = mcap::recordAt(impl_->file, offset);
  mcap::Attachment attachment;
  if (!record || !mcap::parse(record->content, attachment)) {
    return Error{ErrorKind::damaged, "the attachment is malformed", place};
  }
  if (attachment.crc != 0 && crc32(attachment.checked) != attachment.crc) {
    return Error{ErrorKind::damaged,
                 fmt::format("attachment {} fails its checksum", attachment.name), place};
  }
  return Bytes(attachment.data.begin(), attachment.data.end());
}

Status LogReader::seek(LogTime moment) {
  impl_->merge->seek({moment, 0});
  return {};
}

Status LogReader::seekAfter(LogPosition place) {
  impl_->merge->seek(SpanMerge::behind(place));
  return {};
}

Status LogReader::rewind() { return seek(kFirstMoment); }

Result<std::optional<LogMessage>> LogReader::next() { return impl_->merge->next(); }

Result<std::optional<LogMessage>> LogReader::previous() { return impl_->merge->previous(); }

Result<std::optional<LogMessage>> LogReader::nextInFile() { return impl_->in_file->next(); }

void LogReader::skipInFile() { impl_->in_file->skipAll(); }

bool LogReader::inOrderAt(LogPosition place) { return impl_->in_file->inOrderAt(place); }

Result<std::optional<LogMessage>> LogReader::lastOf(ChannelId channel, LogTime moment) {
  if (!impl_->last) impl_->last.emplace(*impl_->cache);
  return impl_->last->find(channel, moment);
}

}  // namespace rocinante
