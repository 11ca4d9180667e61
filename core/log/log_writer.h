#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/log/log_types.h"
#include "core/result.h"

namespace rocinante {

struct LogWriterOptions {
  enum class Compression { none, zstd } compression = Compression::zstd;
  int zstd_level = 1;
  std::size_t chunk_bytes = 1U << 20U;  ///< uncompressed; a chunk is closed when it holds this
  Nanoseconds sync{std::chrono::milliseconds(100)};  ///< a chunk older than this is closed
  bool overwrite = false;  ///< else an existing file is refused
};

/// Writes a log (docs/log-format.md). Messages must come in time order. Not for sharing between
/// threads; starts none. Every call answers; close() must be called and its answer looked at: the
/// destructor is only a net.
class LogWriter {
 public:
  /// refused when the file exists and `overwrite` is false; unreadable when it cannot be made.
  static Result<LogWriter> create(const std::filesystem::path& path,
                                  const LogWriterOptions& options, std::string session_id);

  ~LogWriter();
  LogWriter(LogWriter&&) noexcept;
  LogWriter& operator=(LogWriter&&) noexcept;

  /// Gives the channel the next free id; the same topic may come again with other metadata.
  Result<ChannelId> addChannel(std::string topic, std::string encoding,
                               std::map<std::string, std::string> metadata);

  Status write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
               std::int64_t publish_time_ns, ByteView payload);
  Status writeLoss(const LossSpan& span);
  Status writeAttachment(std::string name, std::string media_type, LogTime time, ByteView data);
  Status writeMetadata(const LogMetadata& metadata);

  /// When the session began, if that is not this file's first captured message (tools that cut or
  /// split copy it). Must come before the first captured message.
  void setOrigin(LogTime origin);

  /// Closes the open chunk when it is older than `sync`: call it now and then, also when idle.
  Status flushIfDue(SteadyTime now);

  /// Writes the summary and rocinante.end with `reason`, flushes to the disk, closes the file.
  Status close(std::string reason);

  std::uint64_t bytesWritten() const;

 private:
  struct Impl;
  explicit LogWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
