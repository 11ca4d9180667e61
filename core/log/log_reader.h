#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_types.h"
#include "core/log/unreadable_range.h"

namespace rocinante {

/// What a log says of itself, counted over captured channels only.
struct LogSummary {
  std::string session_id;
  LogTime origin{};  ///< the first captured datagram of the session; times are shown from it
  LogTime start{};   ///< first captured message of this file; origin when there is none
  LogTime end{};     ///< last captured message of this file
  std::uint64_t messages = 0;
  std::string profile;     ///< of MCAP: "rocinante" for ours
  std::string library;     ///< who wrote it
  std::string format;      ///< that rocinante.session gives; empty where it gives none
  bool closed = false;     ///< its writer ended it: the Footer and the closing magic are there
  bool complete = false;   ///< closed, and one of ours has rocinante.end
  std::string end_reason;  ///< of rocinante.end
};

/// How a log is stored, over its chunks.
struct LogStorage {
  std::uint64_t file_bytes = 0;
  std::uint64_t chunks = 0;
  std::uint64_t stored_bytes = 0;    ///< of the chunks' records, as they lie in the file
  std::uint64_t expanded_bytes = 0;  ///< of the same, as their headers give it
  /// "zstd", "none", "lz4", sorted, each once; "none" also stands for messages outside chunks.
  std::vector<std::string> compressions;
};

/// Reads a log in time order: (log_time, file offset). Holds few chunks in memory whatever the
/// file's size. Format: docs/log-format.md. Not for sharing between threads; open one each.
class LogReader {
 public:
  /// not_found or unreadable when the file is; damaged when it does not begin as a log does.
  /// A log without a summary (its recorder was killed) opens, and is scanned once.
  static Result<LogReader> open(const std::filesystem::path& path);
  /// The same over bytes in memory, which must outlive the reader: for tests and fuzzers.
  static Result<LogReader> openBytes(ByteView bytes, std::string name);

  ~LogReader();
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;

  const LogSummary& summary() const;
  LogStorage storage() const;
  /// By id; channels of the whole file.
  const std::vector<LogChannel>& channels() const;
  const std::vector<LogMetadata>& metadata() const;
  const std::vector<LogAttachment>& attachments() const;
  Result<Bytes> readAttachment(std::size_t index) const;
  /// Losses that the recorder stored, oldest first; looked for when first asked for.
  const std::vector<LossSpan>& losses() const;
  /// What was found broken so far; grows as reading goes on.
  const std::vector<DamageSpan>& damage() const;
  /// Where the messages lie that it cost; of what was found so far too. A chunk that was read once
  /// is known: whoever reads a part of the log knows all that cannot be read there.
  const std::vector<UnreadableRange>& unreadable() const;

  /// Goes to the first message with log_time >= `moment`: the next that next() returns.
  Status seek(LogTime moment);
  /// Goes to the very first message.
  Status rewind();
  /// The next message in time order, of every channel (captured or not). Empty at the end.
  /// Damage is no error: it is skipped and listed by damage().
  Result<std::optional<LogMessage>> next();
  /// The message before the one that next() would return, and goes there: next() and previous()
  /// walk over the same messages in both directions. Empty at the beginning.
  Result<std::optional<LogMessage>> previous();
  /// Goes behind a message: next() returns the first after `place`.
  Status seekAfter(LogPosition place);
  /// The last message of the channel at or before `moment`, found by the indexes; the reader does
  /// not move, but its payload is borrowed until the next call of any kind.
  Result<std::optional<LogMessage>> lastOf(ChannelId channel, LogTime moment);
  /// True when no message that stands behind `place` (of a message) in the file sorts before it:
  /// then what was folded up to there is all that comes before it. The reader does not move.
  bool inOrderAt(LogPosition place);

  const std::string& name() const;  ///< of the file, for messages to people

 private:
  struct Impl;
  explicit LogReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// SHA-256 over (topic, log_time, payload) of the captured messages in order: the identity of a
/// session (docs/log-format.md). Lower-case hexadecimal. Rewinds the reader before and after. Of a
/// damaged log it is the hash of what can be read: damage() says whether that is all.
Result<std::string> contentSha256(LogReader& reader);

}  // namespace rocinante
