#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"

namespace rocinante {

/// Lock that one process at a time can hold on a folder. flock() is applied to the folder itself,
/// so no file is left behind; the lock ends with the object or the process.
class FolderLock {
 public:
  /// Waits until the current holder releases it. refused when the folder cannot be locked.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  /// Does not wait: empty when another process holds the lock or the folder cannot be locked.
  static std::optional<FolderLock> tryTake(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace rocinante
