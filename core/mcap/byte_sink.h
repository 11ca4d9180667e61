#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// Output for a log's bytes. It grows at the end; earlier bytes can be overwritten if the sink is a
/// file. Every call returns its result and resumes by itself after interruptions and short writes.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends all of `bytes`, or fails: then any part of them may already be written.
  virtual Status append(ByteView bytes) = 0;
  /// Removes everything after `size_bytes`, after a failed append. Space reserved behind it may be
  /// released too.
  virtual Status truncate(std::uint64_t size_bytes) = 0;

  /// False if it can only grow at its end: a pipe, a device.
  virtual bool overwritable() const { return false; }
  /// Overwrites appended bytes. After a failure any leading part of them may have been overwritten.
  virtual Status overwriteAt(std::uint64_t offset, ByteView bytes);

  /// Allocates disk space, so that appending up to a size of `size_bytes` cannot fail for lack of
  /// it. Does nothing, without an error, on a file system without preallocation. Fails when there
  /// is no room: then nothing was written. close() releases the unused space.
  virtual Status reserve(std::uint64_t size_bytes);
  /// Lets the system start writing these bytes to the disk, without waiting.
  virtual Status startWriteback(std::uint64_t offset, std::uint64_t size_bytes);

  /// damaged when the appended bytes are no longer in a file with a name: another program deleted,
  /// replaced or truncated it. Appending continues all the same, and close() returns this error
  /// too.
  virtual Status check() { return {}; }

  /// Waits until everything is on the disk (fdatasync), then closes. Called once, last.
  virtual Status close() = 0;

  virtual const std::string& name() const = 0;  ///< for messages to people
};

/// A sink in memory: `out` grows and must outlive the sink. For a file: LogWriter::create().
std::unique_ptr<ByteSink> makeMemorySink(Bytes& out);

}  // namespace rocinante
