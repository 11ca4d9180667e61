#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string_view>

#include "core/base/file_lock.h"
#include "core/base/result.h"

namespace rocinante {

/// A new file, or folder, beside the one that it will become: OUT.part~ and six random characters,
/// so that what a killed process left is never in the way. It is locked (core/base/file_lock.h)
/// until it is published; a file that is not locked is such a leftover, and make() removes those of
/// the same output. Removed with this unless published. Move-only.
class PartFile {
 public:
  /// unreadable, naming `path`, when the system cannot create it.
  static Result<PartFile> make(const std::filesystem::path& path, mode_t mode = 0644);
  /// Leftover folders stay: what is in one may have been put there since.
  static Result<PartFile> makeFolder(const std::filesystem::path& path);

  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&& other) noexcept;

  const std::filesystem::path& beside() const { return beside_; }
  /// Another descriptor of the file, for writing; it shares the lock, and the caller closes it.
  Result<int> writer() const;

  /// Gives it its name. refused when there is a file and `overwrite` is false, however late that
  /// one came, or when another process is writing a log there. A folder replaces an empty one only.
  Status publish(bool overwrite);
  /// The same for a file that the caller holds while it is replaced.
  Status publishOver(const HeldFile& held);

 private:
  PartFile() = default;
  void swap(PartFile& other) noexcept;
  void published();

  std::filesystem::path path_, beside_;  ///< `beside_` is empty once published
  int file_ = -1;
  bool is_folder_ = false;
};

/// OUT.part~ and `six`. A name that the file system would not take with that is shortened.
std::filesystem::path partPath(const std::filesystem::path& path, std::string_view six);

}  // namespace rocinante
