#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// A file that is being written is locked with flock(2) on the file itself, so that the lock ends
/// with the process, however that ends. Whoever would put another file in its place asks here
/// first. Any thread.

/// Whether a file is protected by its lock.
enum class Lock {
  taken,
  unsupported,  ///< the file system has no such locks: nothing stops a second writer
};

/// Takes the lock of an open file, which is released when its last descriptor is closed. refused
/// when another process has it, with that process's id where the system tells it. `path` is for the
/// message.
Result<Lock> lockFile(int file, const std::filesystem::path& path);

/// Holds on to what stands at a path while it is replaced by another file (rename). Nothing, where
/// nothing or no regular file stands there. Move-only.
class HeldFile {
 public:
  enum class For {
    replacing,  ///< shared: files that are whole already may replace each other
    writing,    ///< alone: of two that begin to write here, one gets it
  };
  /// refused when another process is writing the file.
  static Result<HeldFile> at(const std::filesystem::path& path, For purpose);

  ~HeldFile();
  HeldFile(HeldFile&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  HeldFile& operator=(HeldFile&&) = delete;

  /// Something stood there.
  bool holds() const { return file_ >= 0; }

 private:
  explicit HeldFile(int file) : file_(file) {}
  int file_;
};

/// refused when another process is writing what stands at `path`: asked before work whose result
/// would replace it.
Status mayReplace(const std::filesystem::path& path);

/// The file at `path` is this open one.
bool isOpenFile(const std::filesystem::path& path, int file);

/// The process that has locked the file of this inode alone, by `table` (the text of /proc/locks).
std::optional<int> lockHolder(std::string_view table, std::uint64_t inode);

}  // namespace rocinante
