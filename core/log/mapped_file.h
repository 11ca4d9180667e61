#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A file's bytes, read as the system pages them in. The length is that at opening: what is
/// appended later is not seen. Where a file is made shorter meanwhile, the system kills who looks
/// at what is gone (SIGBUS): what is used in quantity is read(), and whole() asked before anything
/// else is looked at long after opening.
class MappedFile {
 public:
  /// not_found or unreadable; a folder or a device is unreadable.
  static Result<MappedFile> open(const std::filesystem::path& path);

  MappedFile() = default;
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;

  /// Valid while this lives, wherever it is moved.
  ByteView bytes() const { return bytes_; }

  /// False when the file has become shorter than it was at opening.
  bool whole() const;
  /// Copies bytes of the file; false when they are not all there, or cannot be read.
  bool read(std::uint64_t offset, std::span<std::byte> out) const;

 private:
  ByteView bytes_;
  int file_ = -1;
};

}  // namespace rocinante
