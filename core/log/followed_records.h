#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/log/followed_file.h"
#include "core/log/log_types.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/open_chunk_stream.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {

/// A record of a log that is being written. Borrowed until the next call of step().
struct FollowedRecord {
  mcap::Record record;     ///< its offset is that in the expanded chunk; 0 outside of chunks
  std::uint64_t span = 0;  ///< number of its chunk, or message outside of chunks, in the file
  bool quiet = false;      ///< it was whole before the place from which messages are wanted
};

/// Steps over the Channel, Message and Metadata records of a growing file as soon as each is whole,
/// those of chunks in place of the chunks, also of a chunk that is still open (docs/log-format.md,
/// "The open chunk"). What is broken is skipped and listed. Not for sharing between threads.
class FollowedRecords {
 public:
  explicit FollowedRecords(std::unique_ptr<FollowedFile> file) : file_(std::move(file)) {}

  /// Looks how long the file is now: step() reads up to there. unreadable when it was truncated.
  Status look();
  /// Records before the current end are quiet: chunks of ours that end there are not even expanded.
  void beginAtEnd() { quiet_until_ = size_; }
  /// Takes the magic, if it is whole; false when it is not. damaged when the file has another one.
  Result<bool> readMagic();

  /// The next record; empty when the file ends before it is whole, and after the last: see ended().
  /// An error when there is no way on: what follows is not a record.
  Result<std::optional<FollowedRecord>> step();

  bool ended() const { return stage_ == Stage::ended; }
  const FollowedFile& file() const { return *file_; }
  /// Adds damage of the record that was returned last; `lost` messages, empty when unknown.
  void damaged(std::string cause, std::optional<std::uint64_t> lost = std::nullopt);
  std::vector<DamageSpan> takeDamage() { return std::exchange(damage_, {}); }

 private:
  enum class Stage { between, whole_chunk, open_chunk, open_plain_chunk, ended };

  // Each takes one step from the current stage: false when the file must grow first. A record that
  // it finds is `found_`.
  Result<bool> stepOn();
  Result<bool> stepBetween();
  Result<bool> stepInWholeChunk();
  Result<bool> stepInOpenChunk();
  Result<bool> stepInPlainChunk();

  Result<bool> beginChunk();
  Result<bool> beginOpenChunk(const ChunkHead& head);
  Result<bool> expandWholeChunk();
  Result<bool> takeBetween(mcap::Opcode opcode, std::uint64_t length);
  void endOpenChunk(std::uint64_t bytes, std::uint32_t crc);
  Status checkCompleted();
  void find(const mcap::Record& record, std::uint64_t end);

  bool have(std::uint64_t count) const { return position_ <= size_ && count <= size_ - position_; }
  Status read(std::uint64_t offset, std::uint64_t count);
  Result<std::optional<ChunkHead>> readHead(std::uint64_t offset);
  Error damagedAt(std::uint64_t offset, std::string what) const;

  std::unique_ptr<FollowedFile> file_;
  Stage stage_ = Stage::between;
  std::uint64_t position_ = 0;  ///< of the next unread byte in the file
  std::uint64_t used_ = 0;  ///< bytes already consumed: the file must not become shorter than this
  std::uint64_t size_ = 0;  ///< of the file at the last look
  std::uint64_t quiet_until_ = 0;
  bool ours_ = false;  ///< the header names our profile
  std::uint64_t spans_ = 0;
  std::optional<FollowedRecord> found_;
  std::vector<DamageSpan> damage_;

  mcap::ChunkExpander expander_;
  mcap::ExpansionBudget budget_{0};
  mcap::Scratch scratch_;
  Bytes stored_;  ///< the record being read, or a piece of it
  mcap::RecordStepper in_chunk_{ByteView()};
  std::uint64_t chunk_from_ = 0;  ///< of the chunk or record being read
  std::uint64_t chunk_to_ = 0;

  mcap::OpenChunkStream stream_;   ///< of a compressed open chunk
  std::uint64_t charged_ = 0;      ///< the part of it charged to the budget
  std::uint64_t plain_start_ = 0;  ///< offset of an uncompressed one's records
  std::uint32_t plain_crc_ = 0;
  std::uint64_t expanded_bytes_ = 0;  ///< of the open chunk that ended last
  std::uint32_t expanded_crc_ = 0;
  bool completed_unchecked_ = false;  ///< that chunk's final header was not compared with it yet
};

}  // namespace rocinante
