#pragma once

#include <filesystem>

#include "core/bytes.h"
#include "core/result.h"

namespace rocinante {

/// A file's bytes, read as the system pages them in. The length is that at opening: what is
/// appended later is not seen. The file must not be made shorter while it is mapped.
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

 private:
  ByteView bytes_;
};

}  // namespace rocinante
