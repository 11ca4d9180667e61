#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"

namespace rocinante {

/// Only one process holds a folder at a time. The lock is on the folder itself (flock), so that no
/// file is left behind, and ends with the object or the process.
class FolderLock {
 public:
  /// Waits until whoever holds it is done. refused when the folder cannot be locked.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  /// Waits for nobody: empty when somebody holds it, or it cannot be locked.
  static std::optional<FolderLock> tryTake(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace rocinante
