#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/mapped_file.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/records.h"

namespace rocinante {

/// What is read at once: a chunk, or a run of messages that lie outside chunks. Spans are numbered
/// in the file's order.
struct MessageSpan {
  std::uint64_t offset = 0;     ///< of its first byte in the file
  std::uint64_t end = 0;        ///< behind its last
  std::uint64_t index_end = 0;  ///< behind its message indexes, which begin at `end`
  LogTime start_time{};         ///< of its earliest message
  LogTime end_time{};           ///< of its latest
  bool loose = false;           ///< messages outside chunks
  bool cut = false;             ///< its header does not tell its end: its recorder was killed in it
  bool over_budget = false;     ///< not to be expanded: mcap::ExpansionBudget
  /// `chunk` is what the summary says; the header in the file, which has the checksum, is looked at
  /// when the chunk is used: to look at each when the file is opened would read all of it in.
  bool by_summary = false;
  mcap::Chunk chunk;                ///< borrows from the file; empty for a loose run
  std::vector<ChannelId> channels;  ///< with messages in it, ascending; empty when nobody says
  /// How many messages the indexes behind it speak of, where they were counted.
  std::optional<std::uint64_t> indexed_messages;

  /// False when none of its messages is on the channel.
  bool mayHold(ChannelId channel) const;
};

/// Bytes of a Chunk record before its records, without the name of the compression: the prefix,
/// times, size, checksum, and two lengths.
inline constexpr std::uint64_t kChunkHeadBytes = mcap::kPrefixBytes + 8 + 8 + 8 + 4 + 4 + 8;

/// The messages of one span, in order of (log_time, place in the file).
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
  std::vector<ByteView> channels;  ///< contents of the Channel records in `records`, as they came
  std::vector<DamageSpan> damage;
  mcap::Scratch scratch;

  /// Memory held, as far as it depends on the file.
  std::size_t heldBytes() const { return scratch.capacity() + places.capacity() * sizeof(Place); }
};

/// Expands spans of one file. One a thread.
class SpanDecoder {
 public:
  /// Where `mapped` is given it has the same bytes, and the spans are read from it and not looked
  /// at in memory: so they may vanish, or change, without harm to what was given out. Both must
  /// outlive this. `channels`, by id, tells what is a message of the session; it may be null.
  explicit SpanDecoder(ByteView file, const MappedFile* mapped = nullptr,
                       const std::vector<const LogChannel*>* channels = nullptr)
      : file_(file), mapped_(mapped), channels_(channels) {}

  /// Fills `out`, whose memory is used again. What is broken is in `out.damage`, and left out.
  void decode(const MessageSpan& span, SpanMessages& out);

  /// The chunk of a span that is known by the summary, as the file has it. Where its header says
  /// otherwise the summary is followed, because its checksum covers it and nothing covers the
  /// header; the chunk's own checksum has the last word.
  mcap::Chunk chunkInFile(const MessageSpan& span, std::vector<DamageSpan>& damage) const;

  /// How many messages the MessageIndex records behind a chunk speak of, if there are any: without
  /// keyframes, losses and what else the recorder adds, where the channels are known.
  std::optional<std::uint64_t> indexedMessages(const MessageSpan& span) const;

  /// The channel's MessageIndex behind a chunk, if it is there.
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

/// A log time from the file's unsigned one. What lies beyond 2262 is held at the last moment.
LogTime logTimeOf(std::uint64_t file_time);

}  // namespace rocinante
