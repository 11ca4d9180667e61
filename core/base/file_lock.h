#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// A file that is being written is locked with flock(2) on the file itself, so the lock ends with
/// the process, however the process ends. A program that wants to replace the file asks here first.
/// Any thread.

/// Whether a file is protected by its lock.
enum class Lock {
  taken,
  unsupported,  ///< the file system has no such locks: nothing stops a second writer
};

/// Takes the lock of an open file; it is released when its last descriptor is closed. refused when
/// another process has it, with that process's id if the system gives it. `path` is for the
/// message.
Result<Lock> lockFile(int file, const std::filesystem::path& path);

/// Holds the lock of the file at a path while another file replaces it (rename). Holds nothing
/// where there is no regular file. Move-only.
class HeldFile {
 public:
  enum class For {
    replacing,  ///< shared: complete files may replace each other
    writing,    ///< exclusive: of two writers that begin here, one gets it
  };
  /// refused when another process is writing the file.
  static Result<HeldFile> at(const std::filesystem::path& path, For purpose);

  ~HeldFile();
  HeldFile(HeldFile&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  HeldFile& operator=(HeldFile&&) = delete;

  /// Whether there was a file to hold.
  bool holds() const { return file_ >= 0; }

 private:
  explicit HeldFile(int file) : file_(file) {}
  int file_;
};

/// refused when another process is writing the file at `path`: call it before the work whose result
/// would replace the file.
Status mayReplace(const std::filesystem::path& path);

/// Whether the file at `path` is this open one.
bool isOpenFile(const std::filesystem::path& path, int file);

/// The process with the exclusive lock of this inode, by `table` (the text of /proc/locks).
std::optional<int> lockHolder(std::string_view table, std::uint64_t inode);

}  // namespace rocinante
