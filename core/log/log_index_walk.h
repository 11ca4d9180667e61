#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/log/chunk_indexes.h"
#include "core/log/log_index.h"
#include "core/log/mapped_file.h"
#include "core/log/message_span.h"
#include "core/mcap/records.h"
#include "core/mcap/torn_chunk.h"

namespace rocinante {

/// Where a walk is in its file, and what it carries from one record to the next.
struct WalkPlace {
  std::uint64_t position = mcap::magic().size();
  mcap::ExpansionBudget budget{0};
  bool chunks_seen = false;
  std::optional<MessageSpan> loose;  ///< the open run of loose messages
  std::optional<MessageSpan> chunk;  ///< the chunk whose indexes are being read
  std::vector<mcap::IndexEntries> indexes;
};

/// Walks over one file. Every step either adds a record to the index or reports why it cannot.
class IndexWalk {
 public:
  /// From `place` on. `mapped`: whose bytes these are, if anybody's.
  IndexWalk(ByteView file, const MappedFile* mapped, WalkPlace place, LogIndex& index)
      : file_(file),
        mapped_(mapped),
        decoder_(file),
        probe_(file),
        at_(std::move(place)),
        released_(at_.position),
        index_(index) {}

  /// Takes the records that are complete, and the damage between them, up to the first of which
  /// that is not known: of a chunk that is still open, or that nothing follows yet.
  void runSettled();
  const WalkPlace& place() const { return at_; }

  /// Takes the rest. While the file is `being_written`, a record that is there in part is not
  /// there yet.
  void run(bool being_written);

 private:
  void damaged(std::uint64_t from, std::uint64_t to, std::string cause,
               std::optional<std::uint64_t> lost);

  /// Reports the bytes behind the end of the closed file.
  void takeTrailing(std::uint64_t end);

  /// Whether the record there is complete, and stays as it is. The end of the log is left to run().
  bool settledAt(std::uint64_t position) const;
  /// Whether the end of the file cuts the record there. An open chunk is read as far as it goes.
  bool cutAt(std::uint64_t position) const;
  /// Takes what is no record at the position if that stays so: a whole record follows it, and
  /// between them nothing begins that is a record once the file is longer. `is_whole`: one is there
  /// whole, and is none of ours.
  bool takeSettledDamage(bool is_whole);
  /// Whether a whole record is there, and another one behind it.
  bool followedAt(std::uint64_t position) const;
  /// Whether the end of the file cuts what may be a record there, or the one behind it.
  bool mayGrowAt(std::uint64_t position) const;
  void releasePages();
  /// Takes the record at the position and moves behind it. False when there is none.
  bool takeRecord();
  template <class T>
  bool takeSimple(const mcap::Record& record, T& out);
  /// Unknown fields may follow the known ones. Whole records may not: then the length is wrong, and
  /// trusting it would skip them.
  void moveBehind(const mcap::Record& record, std::size_t used);
  bool takeSchema(const mcap::Record& record);
  bool takeChannel(const mcap::Record& record);
  void define(const mcap::Channel& channel, std::uint64_t from, std::uint64_t to);
  bool takeMessage(const mcap::Record& record);
  void endLooseRun();
  bool takeChunk(const mcap::Record& record);
  MessageSpan& startChunk(const mcap::Chunk& chunk, std::uint64_t offset, std::uint64_t end);
  bool takeMessageIndex(const mcap::Record& record);
  /// Uses the chunk's indexes without expanding it if they match its header, name known channels
  /// only, and a sound record follows (`followed`), so that none is missing; otherwise expands it.
  void endChunk(bool followed);
  template <class Range, class Channel>
  void addSpan(MessageSpan span, const Range& range, Channel channel);
  void expandChunk(MessageSpan span);
  bool takeTornChunk();
  bool takeAttachment(const mcap::Record& record);
  bool takeMetadata(const mcap::Record& record);
  /// The rest is the summary, which is not needed here; but channels without messages are only
  /// there, so it is searched for them as far as it is sound.
  bool takeDataEnd(const mcap::Record& record);
  /// The summary's checksum holds from `start`, wherever its footer says that it begins.
  bool isSound(const mcap::Record& footer_record, std::uint64_t start) const;
  /// Where a piece of the file is missing from one record's end to another's, nothing looks broken.
  void compareCounts(const mcap::Statistics& statistics, std::uint64_t data_end);
  /// Resumes at `next`, the next byte that begins a credible record.
  void skipDamage(std::uint64_t next);

  ByteView file_;
  const MappedFile* mapped_;
  SpanDecoder decoder_;
  RecordProbe probe_;
  WalkPlace at_;
  std::uint64_t released_;  ///< the position at the last releasePages()
  LogIndex& index_;
  SpanMessages scratch_;
};

/// Builds the index by walking over the whole file, record by record. Expands chunks only when
/// their message indexes are not sufficient. Continues after damage. The file must start with the
/// magic. `mapped`: whose bytes these are, if anybody's; its pages are released on the way.
LogIndex indexByWalking(ByteView file, const MappedFile* mapped = nullptr);

}  // namespace rocinante
