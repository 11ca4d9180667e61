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

class MappedFile;

/// A log's own data, counted over captured channels only.
struct LogSummary {
  std::string session_id;
  LogTime origin{};  ///< the first captured datagram of the session; times are shown from it
  LogTime start{};   ///< first captured message of this file; origin when there is none
  LogTime end{};     ///< last captured message of this file
  std::uint64_t messages = 0;
  std::string profile;     ///< of MCAP: "rocinante" for ours
  std::string library;     ///< the writer
  std::string format;      ///< from rocinante.session; empty if missing
  bool closed = false;     ///< its writer ended it: it has the Footer and the closing magic
  bool complete = false;   ///< closed, and one of ours has rocinante.end
  std::string end_reason;  ///< of rocinante.end
};

/// How a log is stored, over its chunks.
struct LogStorage {
  std::uint64_t file_bytes = 0;
  std::uint64_t chunks = 0;
  std::uint64_t stored_bytes = 0;    ///< of the chunks' records, as stored
  std::uint64_t expanded_bytes = 0;  ///< of the same, according to their headers
  /// "zstd", "none", "lz4", sorted, each once; "none" also means messages outside chunks.
  std::vector<std::string> compressions;
};

/// Reads a log in time order: (log_time, file offset). Holds few chunks in memory, independent of
/// the file's size. Format: docs/log-format.md. Not for sharing between threads; open one each.
class LogReader {
 public:
  /// not_found or unreadable when the file is; damaged when it does not start with the MCAP magic.
  /// A log without a summary (its recorder was killed) opens, and is scanned once.
  static Result<LogReader> open(const std::filesystem::path& path);
  /// The same for a log that may still be written: refresh() adds what is appended. While another
  /// program holds the log's lock, its missing end is no damage.
  static Result<LogReader> openGrowing(const std::filesystem::path& path);
  /// The same to read a log to its end, most simply by nextInFile(). It is taken for being written
  /// until it is closed, locked or not, from its first byte on: an empty file is a log too. Of its
  /// end only what is whole is read, and nothing there is damage. refresh() is unreadable when
  /// another file has taken its name.
  static Result<LogReader> follow(const std::filesystem::path& path);
  /// The same over bytes in memory, which must outlive the reader: for tests and fuzzers.
  static Result<LogReader> openBytes(ByteView bytes, std::string name);

  ~LogReader();
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;

  /// Reads what was appended since the log was opened or refreshed; true when there is something:
  /// messages, channels, the end, or that its writer has gone without one. Then everything borrowed
  /// from this reader is invalid, LogMessage::place() of earlier messages stays valid, and seek()
  /// or seekAfter() must be called before next(). Costs what was appended, and a chunk at most,
  /// behind damage too; all that is behind what may still become a record. unreadable when the log
  /// was truncated. For openGrowing() and follow(); otherwise always false.
  Result<bool> refresh();
  /// More may be appended: another program has the log open for writing.
  bool growing() const;
  /// Its writer has ended the messages. The summary behind them may not be whole yet.
  bool ended() const;

  const LogSummary& summary() const;
  LogStorage storage() const;
  /// By id; channels of the whole file.
  const std::vector<LogChannel>& channels() const;
  const std::vector<LogMetadata>& metadata() const;
  const std::vector<LogAttachment>& attachments() const;
  Result<Bytes> readAttachment(std::size_t index) const;
  /// Losses recorded in the log, oldest first; found on the first call.
  const std::vector<LossSpan>& losses() const;
  /// The damage found so far; grows while reading.
  const std::vector<DamageSpan>& damage() const;
  /// The times of the messages that the damage cost, as far as found. A chunk that was read once is
  /// known completely: after reading a part of the log, everything unreadable there is known.
  const std::vector<UnreadableRange>& unreadable() const;

  /// Moves to the first message with log_time >= `moment`, which next() then returns.
  Status seek(LogTime moment);
  /// Moves to the first message of all.
  Status rewind();
  /// The next message in time order, of every channel (captured or not). Empty at the end. Damage
  /// is not an error: it is skipped and listed by damage().
  Result<std::optional<LogMessage>> next();
  /// The message before the one that next() would return, and moves there: next() and previous()
  /// visit the same messages in opposite directions. Empty at the beginning.
  Result<std::optional<LogMessage>> previous();
  /// Moves behind a message: next() returns the first one after `place`.
  Status seekAfter(LogPosition place);
  /// The last message of the channel at or before `moment`, found through the indexes; the reader
  /// does not move, but the payload is borrowed until the next call of any kind.
  Result<std::optional<LogMessage>> lastOf(ChannelId channel, LogTime moment);
  /// The next message in the order of the file, from its beginning on and independent of next() and
  /// seek(): each once, and after a refresh() also those that were appended with earlier times.
  /// Empty when there is no more yet; its payload is borrowed until the next call of any kind.
  Result<std::optional<LogMessage>> nextInFile();
  /// nextInFile() goes on behind the last message that is there.
  void skipInFile();
  /// True when no message after `place` (of a message) in the file sorts before it: then a fold up
  /// to there includes everything before it. The reader does not move.
  bool inOrderAt(LogPosition place);

  const std::string& name() const;  ///< of the file, for messages to users

 private:
  struct Impl;
  explicit LogReader(std::unique_ptr<Impl> impl);
  enum class Growth { none, while_locked, to_the_end };
  static Result<LogReader> openMapped(Result<MappedFile> mapped, std::string name, Growth growth);
  std::unique_ptr<Impl> impl_;
};

/// The identities of a session (docs/log-format.md, "Identity").
struct SessionHashes {
  std::string content;  ///< content_sha256
  std::string decoded;  ///< decoded_sha256; empty when the log has no decoded packets
};

/// Both hashes in one pass, else as contentSha256().
Result<SessionHashes> sessionHashes(LogReader& reader);

/// SHA-256 over (topic, log_time, payload) of the captured messages in order: the identity of a
/// session (docs/log-format.md). Lower-case hexadecimal. Rewinds the reader before and after. For a
/// damaged log it is the hash of the readable messages: damage() says whether any are missing.
Result<std::string> contentSha256(LogReader& reader);

}  // namespace rocinante
