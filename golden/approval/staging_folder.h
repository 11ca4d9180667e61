#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "golden/store/folder_lock.h"

namespace rocinante {

/// A hidden folder for files that are renamed into its parent later. Its owner holds a lock on it
/// that ends with the process, so an unlocked one was left by a killed process.
class StagingFolder {
 public:
  /// Locks `folder` while creating it.
  static Result<StagingFolder> make(const std::filesystem::path& folder);

  ~StagingFolder();  ///< removes the folder and its contents
  StagingFolder(StagingFolder&&) noexcept = default;
  StagingFolder& operator=(StagingFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  StagingFolder(std::filesystem::path path, FolderLock lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  FolderLock lock_;
};

/// True for a staging folder whose lock no process holds.
bool isAbandonedStaging(const std::filesystem::path& path);
/// Removes abandoned staging folders in `folder`. Requires the lock of `folder`, so that none is
/// being created.
void removeAbandonedStaging(const std::filesystem::path& folder);

}  // namespace rocinante
