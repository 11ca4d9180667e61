#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A file's bytes, paged in by the system as they are read. The length is that at opening: later
/// appends are seen after grow() only. If the file is truncated meanwhile, accessing the missing
/// part kills the process (SIGBUS): so use read() for large parts, and check whole() before
/// accessing anything long after opening.
class MappedFile {
 public:
  /// not_found or unreadable; a folder or a device is unreadable.
  static Result<MappedFile> open(const std::filesystem::path& path);
  /// The same for a file that grows: address space is reserved behind its end, so that grow() can
  /// make bytes() longer in place.
  static Result<MappedFile> openGrowing(const std::filesystem::path& path);

  MappedFile() = default;
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;

  /// Valid while this object lives, also after a move.
  ByteView bytes() const { return bytes_; }

  /// Makes bytes() as long as the file is now; everything borrowed from it stays valid. False when
  /// it is as long as before. An error when the file has become shorter than `needed_bytes` (behind
  /// them it may: a writer takes back what the disk has refused in part), or longer than the
  /// reserved address space (256 GiB, or less where the system gives less).
  Result<bool> grow(std::uint64_t needed_bytes);

  /// Another program, or another part of this one, holds the file's lock: it is writing
  /// (core/base/file_lock.h). False where the file system has no locks.
  bool beingWritten() const;

  /// Another file has the name now. False when none has it.
  bool replaced() const;

  /// False when the file has become shorter since it was opened.
  bool whole() const;
  /// Copies bytes of the file; false when some are missing or cannot be read. Now and then it calls
  /// releasePages(), so that reading a file of any size needs little memory. From any thread.
  bool read(std::uint64_t offset, std::span<std::byte> out) const;
  /// Takes the pages that were accessed out of this process's memory. bytes() stays valid: what is
  /// accessed again is paged in again. From any thread.
  void releasePages() const;

 private:
  static Result<MappedFile> openWithRoom(const std::filesystem::path& path, std::uint64_t room);

  ByteView bytes_;
  std::size_t mapped_bytes_ = 0;  ///< with the room behind the file's end
  std::string name_;
  int file_ = -1;
  mutable std::atomic<std::uint64_t> read_bytes_{0};  ///< by read(), since pages were released
};

}  // namespace rocinante
