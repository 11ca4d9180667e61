#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/log/log_types.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

struct LogWriterOptions {
  enum class Compression { none, zstd } compression = Compression::zstd;
  int zstd_level = 1;
  std::size_t chunk_bytes = 1U << 20U;  ///< uncompressed; a chunk is closed at this size
  /// A killed process loses at most the messages of this time: half of it passes before
  /// flushIfDue() writes a message to the file, the other half is for the caller.
  Nanoseconds sync{std::chrono::milliseconds(100)};
  /// Disk space reserved for losses that are reported after the disk has refused; room for the
  /// summary and rocinante.end is reserved separately.
  std::uint64_t closing_room_bytes = 16U << 10U;
  bool overwrite = false;  ///< a new file replaces an existing one; otherwise refused
};

/// Writes a log (docs/log-format.md). Messages should come in time order: a late one is kept and
/// read at its time, but makes reading slower. Not for sharing between threads; starts none. Every
/// call returns its result; close() must be called and its result checked: the destructor is only a
/// safety net.
class LogWriter {
 public:
  /// refused when the file exists and `overwrite` is false, or another process is writing it;
  /// unreadable when it cannot be created, or the disk has no room for a log without messages. Then
  /// no empty file is left behind, and an older one stays.
  static Result<LogWriter> create(const std::filesystem::path& path,
                                  const LogWriterOptions& options, std::string session_id);
  /// The same on any sink.
  static Result<LogWriter> createOn(std::unique_ptr<ByteSink> sink, const LogWriterOptions& options,
                                    std::string session_id);

  ~LogWriter();
  LogWriter(LogWriter&&) noexcept;
  LogWriter& operator=(LogWriter&&) noexcept;

  /// Gives the channel the next free id; a topic may be added again with other metadata. `schema`
  /// is null but for imported channels; equal ones are stored once, at most 65,535.
  Result<ChannelId> addChannel(std::string topic, std::string encoding,
                               std::map<std::string, std::string> metadata,
                               std::shared_ptr<const LogSchema> schema = nullptr);

  /// Once the disk has refused a write, every further message is refused with the same error and
  /// counted by refusedByDisk(). Losses can still be written, and close() still makes a whole file:
  /// room was reserved for both if the file system supports it.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload);
  Status writeLoss(const LossSpan& span);
  Status writeAttachment(std::string name, std::string media_type, LogTime time, ByteView data);
  Status writeMetadata(const LogMetadata& metadata);

  /// The start of the session, if it is not this file's first captured message (tools that cut or
  /// split copy it). Must come before the first captured message.
  void setOrigin(LogTime origin);

  /// Writes messages to the file that have waited for `sync`/2 or longer: call it about four times
  /// per `sync`, also when idle. It is the log's only clock: a message counts as received at the
  /// previous call. The chunk stays open until it is full.
  Status flushIfDue(SteadyTime now);

  /// The same now, regardless of the waiting time: losses that the disk causes here can still be
  /// recorded.
  Status flush();

  /// damaged when another program has deleted, replaced or truncated the file since it was made;
  /// close() checks this too. Later data is still written.
  Status check();
  /// False if the file system has no locks: nothing prevents a second writer.
  bool locked() const;

  /// Writes the summary and rocinante.end with `reason`, flushes to the disk, closes the file.
  /// After a refused write it returns that first error, even when the file could still be finished.
  Status close(std::string reason);

  /// Bytes in the file, including the flushed part of the open chunk.
  std::uint64_t bytesWritten() const;
  /// Per channel: messages given to write() that are not in the file because the disk refused them,
  /// including those of a chunk that write() had accepted before. Complete once a write failed.
  const std::map<ChannelId, std::uint64_t>& refusedByDisk() const;

 private:
  struct Impl;
  explicit LogWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
