#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A file's bytes, paged in by the system as they are read. The length is that at opening: later
/// appends are not seen. If the file is truncated meanwhile, accessing the missing part kills the
/// process (SIGBUS): so use read() for large parts, and check whole() before accessing anything
/// long after opening.
class MappedFile {
 public:
  /// not_found or unreadable; a folder or a device is unreadable.
  static Result<MappedFile> open(const std::filesystem::path& path);

  MappedFile() = default;
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;

  /// Valid while this object lives, also after a move.
  ByteView bytes() const { return bytes_; }

  /// False when the file has become shorter since it was opened.
  bool whole() const;
  /// Copies bytes of the file; false when some are missing or cannot be read.
  bool read(std::uint64_t offset, std::span<std::byte> out) const;

 private:
  ByteView bytes_;
  int file_ = -1;
};

}  // namespace rocinante
