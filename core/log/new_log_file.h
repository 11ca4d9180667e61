#pragma once

#include <filesystem>
#include <memory>

#include "core/base/file_lock.h"
#include "core/base/part_file.h"
#include "core/mcap/byte_sink.h"
#include "core/mcap/file_sink.h"

namespace rocinante {

/// A file for a new log. It is locked (core/base/file_lock.h) while its sink is open, so that two
/// programs never write one log. An existing file is replaced by publish() and not touched before:
/// its readers keep it. Every file of a log is made here.
class NewLogFile {
 public:
  /// refused when a file exists at `path` and `overwrite` is false, or when another process is
  /// writing it; unreadable when the system cannot create it. A pipe or a device is written to
  /// directly, if `overwrite` is true.
  static Result<NewLogFile> make(const std::filesystem::path& path, bool overwrite,
                                 FileCalls calls = FileCalls::system());

  /// Removes the file unless it was published.
  ~NewLogFile();
  NewLogFile(NewLogFile&& other) noexcept;
  NewLogFile& operator=(NewLogFile&&) = delete;

  /// False if the file system has no locks: nothing prevents a second writer.
  bool locked() const { return locked_; }
  /// Can be taken once.
  std::unique_ptr<ByteSink> takeSink() { return std::move(sink_); }

  /// The file stays, and replaces an older one.
  Status publish();

 private:
  NewLogFile() = default;
  static Result<NewLogFile> makeFree(const std::filesystem::path& path, FileCalls& calls);
  static Result<NewLogFile> makeInPlaceOf(const std::filesystem::path& path, HeldFile old,
                                          FileCalls& calls);
  static Result<NewLogFile> openAsItIs(const std::filesystem::path& path, FileCalls& calls);

  std::filesystem::path path_;     ///< of the log
  std::filesystem::path made_;     ///< the same until publish(); empty: nothing to remove
  std::unique_ptr<HeldFile> old_;  ///< the file that `part_` will replace
  std::unique_ptr<PartFile> part_;
  std::unique_ptr<ByteSink> sink_;
  bool locked_ = true;
};

}  // namespace rocinante
