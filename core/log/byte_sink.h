#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "core/bytes.h"
#include "core/result.h"

namespace rocinante {

/// Where a log's bytes go, from first to last. Every call answers.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends all of `bytes`, or fails: then any part of them may stand there already.
  virtual Status append(ByteView bytes) = 0;
  /// Takes back what stands behind `size_bytes`, after a failed append.
  virtual Status truncate(std::uint64_t size_bytes) = 0;
  /// Hands everything to the disk (fdatasync), then closes. Called once.
  virtual Status close() = 0;

  virtual const std::string& name() const = 0;  ///< for messages to people
};

/// A new file, or an existing one emptied when `overwrite` is true. refused when it exists and
/// `overwrite` is false; unreadable when the system will not make it.
Result<std::unique_ptr<ByteSink>> makeFileSink(const std::filesystem::path& path, bool overwrite);

/// The same, in memory: `out` grows and must outlive the sink.
std::unique_ptr<ByteSink> makeMemorySink(Bytes& out);

/// write(2), as a value: tests hand in a system that is interrupted, writes half, or is full.
using WriteFunction = std::function<ssize_t(int, const void*, std::size_t)>;

/// Writes all of `bytes`: goes on after short writes and EINTR, fails with the system's reason.
Status writeAll(int file, ByteView bytes, const std::string& name, const WriteFunction& write);

}  // namespace rocinante
