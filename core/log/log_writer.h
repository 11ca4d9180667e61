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
  std::size_t chunk_bytes = 1U << 20U;  ///< uncompressed; a chunk is closed when it holds this
  /// A process that is killed loses at most what it was given in this time: half of it passes
  /// before flushIfDue() brings a message into the file, the other half is for its caller.
  Nanoseconds sync{std::chrono::milliseconds(100)};
  /// Kept free on the disk for losses that are told after it has refused; room for the summary and
  /// rocinante.end is kept beside it.
  std::uint64_t closing_room_bytes = 16U << 10U;
  bool overwrite = false;  ///< a new file replaces an existing one, which is refused otherwise
};

/// Writes a log (docs/log-format.md). Messages should come in time order: one that is late is kept
/// and read at its time, but slows reading down. Not for sharing between threads; starts none.
/// Every call answers; close() must be called and its answer looked at: the destructor is only a
/// net.
class LogWriter {
 public:
  /// refused when the file exists and `overwrite` is false, or another process is writing it;
  /// unreadable when it cannot be made, or the disk has no room for a log without messages. No
  /// empty file is left behind then, and an older one stays.
  static Result<LogWriter> create(const std::filesystem::path& path,
                                  const LogWriterOptions& options, std::string session_id);
  /// The same on any sink.
  static Result<LogWriter> createOn(std::unique_ptr<ByteSink> sink, const LogWriterOptions& options,
                                    std::string session_id);

  ~LogWriter();
  LogWriter(LogWriter&&) noexcept;
  LogWriter& operator=(LogWriter&&) noexcept;

  /// Gives the channel the next free id; the same topic may come again with other metadata.
  Result<ChannelId> addChannel(std::string topic, std::string encoding,
                               std::map<std::string, std::string> metadata);

  /// Once the disk has refused a write, every further message is refused with the same error and
  /// counted by refusedByDisk(); losses can still be told, and close() still makes a whole file,
  /// for which room was kept where the file system can do that.
  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload);
  Status writeLoss(const LossSpan& span);
  Status writeAttachment(std::string name, std::string media_type, LogTime time, ByteView data);
  Status writeMetadata(const LogMetadata& metadata);

  /// When the session began, if that is not this file's first captured message (tools that cut or
  /// split copy it). Must come before the first captured message.
  void setOrigin(LogTime origin);

  /// Brings messages into the file that wait for `sync`/2 or longer: call it some four times in
  /// each `sync`, also when idle. The log's only clock: a message counts as given at the call
  /// before it. A chunk goes on after that, until it is full.
  Status flushIfDue(SteadyTime now);

  /// The same now, whatever waits for how long: what the disk refuses of it can still be told.
  Status flush();

  /// damaged when another program deleted, replaced or cut the file since it was made; close()
  /// looks too. What is written after that is written all the same.
  Status check();
  /// False where the file system has no locks: nothing stops a second program from writing here.
  bool locked() const;

  /// Writes the summary and rocinante.end with `reason`, flushes to the disk, closes the file.
  /// After a refused write it answers that first error, even when the file could still be finished.
  Status close(std::string reason);

  /// What stands in the file, the flushed part of the open chunk included.
  std::uint64_t bytesWritten() const;
  /// Per channel: messages given to write() that do not stand in the file because the disk refused
  /// them, those of a chunk that write() had taken already included. Complete once a write failed.
  const std::map<ChannelId, std::uint64_t>& refusedByDisk() const;

 private:
  struct Impl;
  explicit LogWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
