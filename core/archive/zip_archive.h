#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A ZIP file of a stranger, read by libzip. Nothing in it decides where a file is written: the
/// caller asks for bytes by name. unsupported in builds without libzip (`--version --parts`).
class ZipArchive {
 public:
  /// damaged when it is not a ZIP file.
  static Result<ZipArchive> open(const std::filesystem::path& path);
  /// Borrows the bytes; `file` is used in messages.
  static Result<ZipArchive> ofBytes(ByteView bytes, const std::string& file);

  ~ZipArchive();
  ZipArchive(ZipArchive&&) noexcept;
  ZipArchive& operator=(ZipArchive&&) = delete;

  /// Names of the files in it as they are written there, in its order; folders are left out.
  const std::vector<std::string>& names() const { return names_; }
  /// The content of one of names(): the first of that name. refused when it says that it is larger
  /// than `most_bytes`, before anything is allocated for it; damaged when its bytes end early, are
  /// more than it says or fail its checksum, and when it is encrypted.
  Result<std::string> read(const std::string& name, std::uint64_t most_bytes) const;

  /// Most files in one archive.
  static constexpr std::int64_t kMaxFiles = 100'000;

 private:
  struct Handle;
  explicit ZipArchive(std::unique_ptr<Handle> handle, std::string file);
  static Result<ZipArchive> made(std::unique_ptr<Handle> handle, const std::string& file);

  std::unique_ptr<Handle> handle_;
  std::string file_;
  std::vector<std::string> names_;
};

}  // namespace rocinante
