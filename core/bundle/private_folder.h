#pragma once

#include <filesystem>
#include <memory>

#include "core/base/result.h"

namespace rocinante {

/// A folder of this process alone, in the system's folder for temporary files, deleted with its
/// contents when this object is destroyed. A process that is killed leaves it behind: the next one
/// that makes such a folder removes those whose process has ended.
class PrivateFolder {
 public:
  static Result<std::shared_ptr<const PrivateFolder>> make();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  /// Without links and `..`.
  const std::filesystem::path& path() const { return path_; }

 private:
  PrivateFolder(std::filesystem::path path, int lock);

  std::filesystem::path path_;
  int lock_;  // held as long as the folder is in use
};

}  // namespace rocinante
