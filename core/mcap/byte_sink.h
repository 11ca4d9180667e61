#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// Where a log's bytes go. They grow at the end; what stands there already can be overwritten where
/// the sink is a file. Every call answers, and goes on by itself after interruptions and short
/// writes.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends all of `bytes`, or fails: then any part of them may stand there already.
  virtual Status append(ByteView bytes) = 0;
  /// Takes back what stands behind `size_bytes`, after a failed append. What was reserved behind it
  /// may be gone too.
  virtual Status truncate(std::uint64_t size_bytes) = 0;

  /// False for what can only grow at its end: a pipe, a device.
  virtual bool overwritable() const { return false; }
  /// Overwrites bytes that were appended. After a failure any first part of them may stand there.
  virtual Status overwriteAt(std::uint64_t offset, ByteView bytes);

  /// Allocates room on the disk, so that appending up to a size of `size_bytes` cannot fail for
  /// want of it. Nothing, and no error, where the file system has no such thing. Fails when the
  /// room is not there: nothing was written then. close() gives back what was not used.
  virtual Status reserve(std::uint64_t size_bytes);
  /// Lets the system begin to bring these bytes to the disk, and does not wait for it.
  virtual Status startWriteback(std::uint64_t offset, std::uint64_t size_bytes);

  /// damaged when what was appended does not stand in a file with a name any more: another program
  /// deleted, replaced or cut it. Appending goes on all the same, and close() answers it too.
  virtual Status check() { return {}; }

  /// Waits until everything is on the disk (fdatasync), then closes. Called once, last.
  virtual Status close() = 0;

  virtual const std::string& name() const = 0;  ///< for messages to people
};

/// In memory: `out` grows and must outlive the sink. For a file: LogWriter::create().
std::unique_ptr<ByteSink> makeMemorySink(Bytes& out);

}  // namespace rocinante
