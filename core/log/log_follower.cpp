#include "core/log/log_follower.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "core/base/hash.h"
#include "core/log/followed_file.h"
#include "core/log/log_profile.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/open_chunk_stream.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Before the records of a Chunk: times, sizes, CRC, compression's length, records' length.
constexpr std::size_t kChunkFixedBytes = 8 + 8 + 8 + 4 + 4 + 8;
constexpr std::size_t kMaxCompressionName = 32;
constexpr std::size_t kPieceBytes = 1U << 16U;
/// A larger metadata record or header is not ours, and is skipped.
constexpr std::uint64_t kMaxMetadataBytes = 1U << 24U;

/// The fields before the records of a chunk.
struct ChunkFront {
  std::uint64_t length = 0;  ///< of the record's content
  mcap::Chunk chunk;
  std::uint64_t records_bytes = 0;
  std::size_t front_bytes = 0;  ///< prefix and fields

  /// The records' length is written last, its highest byte at the very end.
  bool open() const { return records_bytes >> 56U == 0xFF; }
};

/// Empty when there are not enough bytes yet, or the compression is unknown.
std::optional<ChunkFront> readFront(ByteView bytes) {
  mcap::ByteCursor cursor(bytes);
  ChunkFront front;
  cursor.take(1);
  front.length = cursor.number<std::uint64_t>();
  front.chunk.message_start_time = cursor.number<std::uint64_t>();
  front.chunk.message_end_time = cursor.number<std::uint64_t>();
  front.chunk.uncompressed_size = cursor.number<std::uint64_t>();
  front.chunk.uncompressed_crc = cursor.number<std::uint32_t>();
  front.chunk.compression = cursor.string();
  front.records_bytes = cursor.number<std::uint64_t>();
  front.front_bytes = cursor.position();
  if (!cursor.ok()) return std::nullopt;
  return front;
}

}  // namespace

struct LogFollower::Impl {
  explicit Impl(std::unique_ptr<FollowedFile> followed) : file(std::move(followed)) {}

  enum class Stage { between, whole_chunk, open_chunk, open_plain_chunk, ended };

  std::unique_ptr<FollowedFile> file;
  Stage stage = Stage::between;
  std::uint64_t position = 0;  ///< of the next unread byte in the file
  std::uint64_t used = 0;  ///< bytes already consumed: the file must not become shorter than this
  std::uint64_t size = 0;  ///< of the file at the last look
  std::uint64_t quiet_until = 0;  ///< messages complete before here are not returned
  std::optional<Error> failure;
  mcap::Header header;
  std::optional<LogTime> origin;
  std::map<ChannelId, LogChannel> channels;
  std::vector<DamageSpan> damage;
  std::uint64_t spans = 0;  ///< chunks, and messages outside of them, begun so far

  mcap::ChunkExpander expander;
  mcap::ExpansionBudget budget{0};
  mcap::Scratch scratch;
  Bytes stored;  ///< the record being read, or a piece of it
  ByteView records;
  std::uint64_t at = 0;  ///< in `records`
  std::uint64_t chunk_from = 0;
  std::uint64_t chunk_to = 0;

  mcap::OpenChunkStream stream;   ///< of a compressed open chunk
  std::uint64_t charged = 0;      ///< the part of it charged to the budget
  std::uint64_t plain_start = 0;  ///< offset of an uncompressed one's records
  std::uint32_t plain_crc = 0;
  std::uint64_t expanded_bytes = 0;  ///< of the open chunk that ended last
  std::uint32_t expanded_crc = 0;
  bool check_patched =
      false;  ///< the open chunk that ended last still has to be compared with its header

  Error damagedAt(std::uint64_t offset, std::string what) const {
    return {ErrorKind::damaged, std::move(what), fmt::format("{}, byte {}", file->name(), offset)};
  }

  /// True when the bytes [position, position + count) exist.
  bool have(std::uint64_t count) const { return position <= size && count <= size - position; }

  Status read(std::uint64_t offset, std::size_t count) {
    stored.resize(count);
    return file->read(offset, stored);
  }

  Status look() {
    const Result<std::uint64_t> now = file->size();
    if (!now) return now.error();
    if (*now < used) {
      return Error{ErrorKind::unreadable, "the file was truncated while it was followed",
                   file->name()};
    }
    size = *now;
    return {};
  }

  Result<std::optional<LogMessage>> poll() {
    if (Status seen = look(); !seen) return seen.error();
    while (true) {
      Result<std::optional<LogMessage>> message = std::optional<LogMessage>();
      bool more = false;
      switch (stage) {
        case Stage::between: {
          const Result<bool> stepped = step(message);
          if (!stepped) return stepped.error();
          more = *stepped;
          break;
        }
        case Stage::whole_chunk:
          message = nextInWholeChunk();
          more = stage != Stage::whole_chunk;
          break;
        case Stage::open_chunk: {
          const Result<bool> stepped = stepInOpenChunk(message);
          if (!stepped) return stepped.error();
          more = *stepped;
          break;
        }
        case Stage::open_plain_chunk: {
          const Result<bool> stepped = stepInPlainChunk(message);
          if (!stepped) return stepped.error();
          more = *stepped;
          break;
        }
        case Stage::ended:
          break;
      }
      if (!message || *message || !more) return message;
    }
  }

  /// Takes the record at `position`. True when it was complete.
  Result<bool> step(Result<std::optional<LogMessage>>& message) {
    if (position == 0) return readMagic();
    if (!have(mcap::kPrefixBytes)) return false;
    if (Status got = read(position, mcap::kPrefixBytes); !got) return got.error();
    const auto opcode = static_cast<Opcode>(stored[0]);
    std::uint64_t length = 0;
    std::memcpy(&length, stored.data() + 1, sizeof(length));
    if (check_patched) {
      check_patched = false;
      if (Status checked = checkPatched(); !checked) return checked.error();
    }
    if (opcode == Opcode::chunk) return beginChunk();
    if (opcode == Opcode::data_end || opcode == Opcode::footer) {
      stage = Stage::ended;
      return true;
    }
    if (opcode == Opcode::invalid || length > std::numeric_limits<std::int64_t>::max() - position) {
      return damagedAt(position, "there is no valid record here");
    }
    const bool wanted = opcode == Opcode::header || opcode == Opcode::channel ||
                        opcode == Opcode::message || opcode == Opcode::metadata;
    const bool is_message = opcode == Opcode::message || opcode == Opcode::channel;
    if (wanted && length <= (is_message ? mcap::kMaxChunkBytes : kMaxMetadataBytes)) {
      const std::uint64_t whole = mcap::kPrefixBytes + length;
      if (!have(whole)) return false;
      if (Status got = read(position, static_cast<std::size_t>(whole)); !got) return got.error();
      mcap::Record record{opcode, 0, ByteView(stored).subspan(mcap::kPrefixBytes)};
      chunk_from = position;
      chunk_to = position + whole;
      position += whole;
      used = position;
      if (opcode == Opcode::message && header.profile == profile::kName) {
        // Our recorders write none: it is another record with a broken opcode.
        damaged("a message is outside the chunks, where no checksum covers it");
        return true;
      }
      if (opcode == Opcode::message) ++spans;
      message = take(record, position);
      return true;
    }
    if (is_message) {
      chunk_from = position;
      chunk_to = position + mcap::kPrefixBytes + length;
      damaged("the record is too large to be read");
    }
    // The next record follows it, perhaps far beyond the current end of the file.
    position += mcap::kPrefixBytes + length;
    return true;
  }

  Result<bool> readMagic() {
    const std::size_t there =
        static_cast<std::size_t>(std::min<std::uint64_t>(size, mcap::magic().size()));
    if (Status got = read(0, there); !got) return got.error();
    if (!std::ranges::equal(stored, mcap::magic().first(there))) {
      return damagedAt(0, "the file does not start with the MCAP magic");
    }
    if (there < mcap::magic().size()) return false;
    used = position = there;
    return true;
  }

  Result<bool> beginChunk() {
    const std::uint64_t most = mcap::kPrefixBytes + kChunkFixedBytes + kMaxCompressionName;
    if (Status got = read(position, static_cast<std::size_t>(std::min(most, size - position)));
        !got) {
      return got.error();
    }
    const std::optional<ChunkFront> front = readFront(stored);
    if (!front) {
      if (stored.size() < most) return false;
      return damagedAt(position, "the header of a chunk is invalid");
    }
    chunk_from = position;
    if (front->open()) {
      const std::string_view compression = front->chunk.compression;
      if (!compression.empty() && compression != "zstd") {
        return damagedAt(position, "an open chunk has a compression other than zstd or none");
      }
      ++spans;
      used = position += front->front_bytes;
      stage = compression.empty() ? Stage::open_plain_chunk : Stage::open_chunk;
      stream.begin();
      charged = 0;
      plain_start = position;
      plain_crc = 0;
      return true;
    }
    if (front->length > std::numeric_limits<std::int64_t>::max() - position ||
        front->length < front->front_bytes - mcap::kPrefixBytes) {
      return damagedAt(position, "the length of a chunk is invalid");
    }
    chunk_to = position + mcap::kPrefixBytes + front->length;
    const bool quiet = chunk_to <= quiet_until && header.profile == profile::kName;
    if (quiet || front->length > mcap::kMaxChunkBytes + most) {
      // Our chunks each define what they use, so skipping one loses nothing else.
      if (!quiet) damaged("the chunk is too large to be read");
      ++spans;
      position = chunk_to;
      return true;
    }
    if (chunk_to > size) return false;
    ++spans;
    return expandWholeChunk();
  }

  Result<bool> expandWholeChunk() {
    if (Status got = read(chunk_from, static_cast<std::size_t>(chunk_to - chunk_from)); !got) {
      return got.error();
    }
    used = position = chunk_to;
    mcap::Chunk chunk;
    if (!mcap::parse(ByteView(stored).subspan(mcap::kPrefixBytes), chunk)) {
      damaged("the chunk's lengths do not fit the chunk");
      return true;
    }
    budget.grow(chunk_to - chunk_from);
    if (!budget.take(chunk)) {
      damaged(mcap::ExpansionBudget::refusal());
      return true;
    }
    const Result<ByteView> expanded = expander.expand(chunk, scratch);
    if (!expanded) {
      damaged(expanded.error().what);
      return true;
    }
    records = *expanded;
    at = 0;
    stage = Stage::whole_chunk;
    return true;
  }

  Result<std::optional<LogMessage>> nextInWholeChunk() {
    while (at < records.size()) {
      const std::optional<mcap::Record> record = mcap::recordAt(records, at);
      if (!record) {
        damaged("a record reaches past the end of its chunk");
        break;
      }
      at = record->end();
      std::optional<LogMessage> message = take(*record, chunk_to);
      if (message) return message;
    }
    stage = Stage::between;
    return std::optional<LogMessage>();
  }

  /// True on progress: a message was found, or the chunk ended.
  Result<bool> stepInOpenChunk(Result<std::optional<LogMessage>>& message) {
    while (true) {
      const std::uint64_t expanded = stream.expandedBytes();
      if (!budget.take(expanded - charged)) {
        return damagedAt(chunk_from, mcap::ExpansionBudget::refusal());
      }
      charged = expanded;
      const Result<std::optional<mcap::Record>> record = stream.next();
      if (!record) return damagedAt(chunk_from, record.error().what);
      if (*record) {
        message = take(**record, position);
        if (*message) return true;
        continue;
      }
      if (stream.ended()) {
        endOpenChunk(stream.expandedBytes(), stream.crc());
        return true;
      }
      // Messages that end before `quiet_until` must be told apart from later ones.
      const std::uint64_t until = position < quiet_until ? std::min(size, quiet_until) : size;
      if (position >= until) return false;
      const auto count =
          static_cast<std::size_t>(std::min<std::uint64_t>(until - position, kPieceBytes));
      if (Status got = read(position, count); !got) return got.error();
      const Result<std::size_t> fed = stream.feed(stored);
      budget.grow(stored.size());
      if (!fed) return damagedAt(chunk_from, fed.error().what);
      used = position += *fed;
    }
  }

  /// The same for an uncompressed chunk: taken record by record, so that a half-written one is
  /// never used.
  Result<bool> stepInPlainChunk(Result<std::optional<LogMessage>>& message) {
    if (!have(mcap::kPrefixBytes)) return false;
    if (Status got = read(position, mcap::kPrefixBytes); !got) return got.error();
    const auto opcode = static_cast<Opcode>(stored[0]);
    if (opcode != Opcode::schema && opcode != Opcode::channel && opcode != Opcode::message) {
      endOpenChunk(position - plain_start, plain_crc);
      return true;
    }
    std::uint64_t length = 0;
    std::memcpy(&length, stored.data() + 1, sizeof(length));
    if (length > mcap::kMaxChunkBytes) {
      return damagedAt(position, fmt::format("a chunk claims a record of {} bytes", length));
    }
    const std::uint64_t whole = mcap::kPrefixBytes + length;
    if (!have(whole)) return false;
    if (Status got = read(position, static_cast<std::size_t>(whole)); !got) return got.error();
    plain_crc = crc32(stored, plain_crc);
    const mcap::Record record{opcode, position - plain_start,
                              ByteView(stored).subspan(mcap::kPrefixBytes)};
    used = position += whole;
    message = take(record, position);
    return true;
  }

  void endOpenChunk(std::uint64_t bytes, std::uint32_t crc) {
    expanded_bytes = bytes;
    expanded_crc = crc;
    check_patched = true;
    stage = Stage::between;
  }

  /// Checks the header of a chunk that was read while open; it is written before anything behind
  /// the chunk.
  Status checkPatched() {
    const std::uint64_t most = mcap::kPrefixBytes + kChunkFixedBytes + kMaxCompressionName;
    const Bytes behind = stored;
    if (Status got = read(chunk_from, static_cast<std::size_t>(std::min(most, size - chunk_from)));
        !got) {
      return got;
    }
    const std::optional<ChunkFront> front = readFront(stored);
    const std::uint64_t end = position;
    chunk_to = end;
    if (!front || front->open()) {
      damaged("the header of a chunk was never closed", 0);
    } else if (chunk_from + front->front_bytes + front->records_bytes != end ||
               front->chunk.uncompressed_size != expanded_bytes ||
               (front->chunk.uncompressed_crc != 0 &&
                front->chunk.uncompressed_crc != expanded_crc)) {
      damaged("the header of a chunk does not match what was read from it", 0);
    }
    stored = behind;
    return {};
  }

  /// Takes the contents of a record; `end`: how far the file had to be read for it.
  std::optional<LogMessage> take(const mcap::Record& record, std::uint64_t end) {
    if (record.opcode == Opcode::message) return takeMessage(record, end);
    if (record.opcode == Opcode::channel) {
      takeChannel(record);
    } else if (record.opcode == Opcode::metadata) {
      takeMetadata(record);
    } else if (record.opcode == Opcode::header) {
      if (!mcap::parse(record.content, header))
        damaged("the header's lengths do not fit the header", 0);
    }
    return std::nullopt;
  }

  std::optional<LogMessage> takeMessage(const mcap::Record& record, std::uint64_t end) {
    mcap::Message message;
    constexpr auto kLast = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (!mcap::parse(record.content, message) || message.log_time > kLast) {
      damaged("a message is malformed", 1);
      return std::nullopt;
    }
    const auto channel = channels.find(message.channel_id);
    if (channel == channels.end()) {
      damaged(fmt::format("a message on channel {}, which was never defined", message.channel_id),
              1);
      return std::nullopt;
    }
    if (end <= quiet_until) return std::nullopt;
    LogMessage out;
    out.channel = &channel->second;
    out.sequence = message.sequence;
    out.log_time = LogTime(Nanoseconds(static_cast<std::int64_t>(message.log_time)));
    out.publish_time_ns = static_cast<std::int64_t>(message.publish_time);
    out.file_offset = ((spans - 1) << 32U) | record.offset;
    out.payload = message.data;
    return out;
  }

  void takeChannel(const mcap::Record& record) {
    mcap::Channel channel;
    if (!mcap::parse(record.content, channel)) return damaged("a channel is malformed");
    LogChannel mine{channel.id, std::move(channel.topic), std::move(channel.message_encoding),
                    std::move(channel.metadata)};
    const auto [known, is_new] = channels.try_emplace(channel.id, mine);
    if (is_new) return;
    if (known->second.topic != mine.topic || known->second.encoding != mine.encoding ||
        known->second.metadata != mine.metadata) {
      damaged(fmt::format("channel {} is defined again as another", channel.id));
    }
  }

  void takeMetadata(const mcap::Record& record) {
    mcap::Metadata metadata;
    if (!mcap::parse(record.content, metadata)) return damaged("a metadata record is malformed", 0);
    if (origin || metadata.name != profile::kSession) return;
    const auto format = metadata.metadata.find(std::string(profile::kFormatKey));
    const std::string said = format == metadata.metadata.end() ? std::string() : format->second;
    if (said != profile::kFormat) damaged(profile::otherFormatText(said), 0);
    const auto entry = metadata.metadata.find(std::string(profile::kOriginKey));
    if (entry == metadata.metadata.end()) return;
    std::int64_t nanoseconds = 0;
    const std::string& text = entry->second;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), nanoseconds);
    if (fault == std::errc() && end == text.data() + text.size()) {
      origin = LogTime(Nanoseconds(nanoseconds));
    }
  }

  /// Reports damage in the record or chunk being read.
  void damaged(std::string cause, std::optional<std::uint64_t> lost = std::nullopt) {
    const bool open = stage == Stage::open_chunk || stage == Stage::open_plain_chunk;
    const std::uint64_t to = open ? position : chunk_to;
    // The same fault of many records in one chunk is reported once.
    if (!damage.empty() && damage.back().from == chunk_from && damage.back().cause == cause) {
      DamageSpan& last = damage.back();
      if (last.messages_lost && lost) *last.messages_lost += *lost;
      return;
    }
    damage.push_back({chunk_from, to, std::move(cause), lost});
  }
};

Result<LogFollower> LogFollower::open(const std::filesystem::path& path, From from) {
  Result<std::unique_ptr<FollowedFile>> file = followFile(path);
  if (!file) return file.error();
  return openOn(std::move(*file), from);
}

Result<LogFollower> LogFollower::openOn(std::unique_ptr<FollowedFile> file, From from) {
  auto impl = std::make_unique<Impl>(std::move(file));
  if (Status seen = impl->look(); !seen) return seen.error();
  if (from == From::now) impl->quiet_until = impl->size;
  const Result<bool> begun = impl->readMagic();
  if (!begun) return begun.error();
  return LogFollower(std::move(impl));
}

LogFollower::LogFollower(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LogFollower::~LogFollower() = default;
LogFollower::LogFollower(LogFollower&&) noexcept = default;
LogFollower& LogFollower::operator=(LogFollower&&) noexcept = default;

Result<std::optional<LogMessage>> LogFollower::poll() {
  if (impl_->failure) return *impl_->failure;
  Result<std::optional<LogMessage>> message = impl_->poll();
  if (!message) impl_->failure = message.error();
  return message;
}

bool LogFollower::ended() const { return impl_->stage == Impl::Stage::ended; }
std::optional<LogTime> LogFollower::origin() const { return impl_->origin; }
std::vector<DamageSpan> LogFollower::takeDamage() { return std::exchange(impl_->damage, {}); }
const std::string& LogFollower::name() const { return impl_->file->name(); }

}  // namespace rocinante
