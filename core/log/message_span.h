#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/mapped_file.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/records.h"

namespace rocinante {

/// The unit of reading: a chunk, or a run of messages outside chunks. Spans are numbered in the
/// file's order.
struct MessageSpan {
  std::uint64_t offset = 0;     ///< of its first byte, in the file
  std::uint64_t end = 0;        ///< behind its last byte
  std::uint64_t index_end = 0;  ///< end of its message indexes, which begin at `end`
  LogTime start_time{};         ///< of its earliest message
  LogTime end_time{};           ///< of its latest
  bool loose = false;           ///< messages outside chunks
  bool cut = false;             ///< its header does not give its end: the recorder was killed in it
  bool over_budget = false;     ///< not to be expanded: mcap::ExpansionBudget
  /// `chunk` is the summary's version. The header in the file, which has the checksum, is read only
  /// when the chunk is used: reading every header at opening would page in the whole file.
  bool by_summary = false;
  mcap::Chunk chunk;                ///< borrows from the file; empty for a loose run
  std::vector<ChannelId> channels;  ///< with messages in it, ascending; empty when unknown
  /// The number of messages in the indexes behind it, if they were counted.
  std::optional<std::uint64_t> indexed_messages;

  /// False when it holds none: then its times, both 0, have no meaning.
  bool hasMessages() const;
  /// False when none of its messages is on the channel.
  bool mayHold(ChannelId channel) const;
};

/// The messages of one span, in order of (log_time, position in the file).
struct SpanMessages {
  struct Place {
    std::int64_t time_ns;
    std::uint32_t offset;  ///< of the Message record in `records`
    ChannelId channel;
    bool operator<(const Place& other) const {
      return time_ns != other.time_ns ? time_ns < other.time_ns : offset < other.offset;
    }
  };

  ByteView records;  ///< borrowed from the file, or from `scratch`
  std::vector<Place> places;
  std::vector<ByteView> channels;  ///< contents of the Channel records in `records`, in file order
  std::vector<ByteView> schemas;   ///< the same of the Schema records
  std::vector<DamageSpan> damage;
  mcap::Scratch scratch;

  /// Memory held, as far as it depends on the file.
  std::size_t heldBytes() const { return scratch.capacity() + places.capacity() * sizeof(Place); }
};

/// Expands spans of one file. One per thread.
class SpanDecoder {
 public:
  /// If `mapped` is given it has the same bytes, and spans are copied from it instead of accessed
  /// in memory, so that they may vanish or change without harm to earlier results. Both must
  /// outlive this. `channels`, by id, tells which messages belong to the session; it may be null.
  explicit SpanDecoder(ByteView file, const MappedFile* mapped = nullptr,
                       const std::vector<const LogChannel*>* channels = nullptr)
      : file_(file), mapped_(mapped), channels_(channels) {}

  /// The file has grown, and is otherwise as before.
  void useFile(ByteView file) { file_ = file; }

  /// Fills `out` and reuses its memory. Broken parts are skipped and listed in `out.damage`.
  void decode(const MessageSpan& span, SpanMessages& out);

  /// The chunk of a span known from the summary, as in the file. If its header disagrees, the
  /// summary is used, because a checksum covers the summary and none the header; the chunk's own
  /// checksum decides in the end.
  mcap::Chunk chunkInFile(const MessageSpan& span, std::vector<DamageSpan>& damage) const;

  /// The number of messages in the MessageIndex records behind a chunk, if there are any and they
  /// agree with its header: without keyframes, losses and other additions of the recorder, if the
  /// channels are known.
  std::optional<std::uint64_t> indexedMessages(const MessageSpan& span) const;

  /// The channel's MessageIndex behind a chunk, if there is one.
  std::optional<mcap::IndexEntries> indexOf(const MessageSpan& span, ChannelId channel) const;

 private:
  bool whole() const { return mapped_ == nullptr || mapped_->whole(); }
  Result<ByteView> stored(ByteView bytes, mcap::Scratch& scratch) const;
  Result<ByteView> expand(const MessageSpan& span, SpanMessages& out);
  void readRecords(const MessageSpan& span, SpanMessages& out);

  ByteView file_;
  const MappedFile* mapped_;
  const std::vector<const LogChannel*>* channels_;
  mcap::Scratch compressed_;
  mcap::ChunkExpander expander_;
};

/// A log time from the file's unsigned one. Times beyond 2262 become the last moment.
LogTime logTimeOf(std::uint64_t file_time);

}  // namespace rocinante
