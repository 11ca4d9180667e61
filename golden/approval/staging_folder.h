#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "golden/approval/folder_lock.h"

namespace rocinante {

/// A hidden folder inside another, for files until they get their names there. Its owner holds its
/// lock, which ends with the process: one that nobody holds was left by a process that was killed.
class StagingFolder {
 public:
  /// Locks `folder` for as long as this takes.
  static Result<StagingFolder> make(const std::filesystem::path& folder);

  ~StagingFolder();  ///< removes it, with what is in it
  StagingFolder(StagingFolder&&) noexcept = default;
  StagingFolder& operator=(StagingFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  StagingFolder(std::filesystem::path path, FolderLock lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  FolderLock lock_;
};

/// True for a staging folder that no living process holds.
bool isAbandonedStaging(const std::filesystem::path& path);
/// Removes those in `folder`. For who holds the lock of `folder`: nobody is making one then.
void removeAbandonedStaging(const std::filesystem::path& folder);

}  // namespace rocinante
