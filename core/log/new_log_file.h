#pragma once

#include <filesystem>
#include <memory>

#include "core/base/file_lock.h"
#include "core/mcap/byte_sink.h"
#include "core/mcap/file_sink.h"

namespace rocinante {

/// A file that a log is about to be written to. It is locked (core/base/file_lock.h) as long as its
/// sink is open, so that two programs never write one log. A file that stands there already is
/// replaced by publish() and not touched before: whoever reads it keeps it. Every file of a log is
/// made here.
class NewLogFile {
 public:
  /// refused when a file exists at `path` and `overwrite` is false, or when another process is
  /// writing it; unreadable when the system will not make one. A pipe or a device is written to as
  /// it is, where `overwrite` allows it.
  static Result<NewLogFile> make(const std::filesystem::path& path, bool overwrite,
                                 FileCalls calls = FileCalls::system());

  /// Removes the file unless it was published.
  ~NewLogFile();
  NewLogFile(NewLogFile&& other) noexcept;
  NewLogFile& operator=(NewLogFile&&) = delete;

  /// False where the file system has no locks: nothing stops a second writer.
  bool locked() const { return locked_; }
  /// To be taken once.
  std::unique_ptr<ByteSink> takeSink() { return std::move(sink_); }

  /// The file stays, and takes the place of an older one.
  Status publish();

 private:
  NewLogFile() = default;
  static Result<NewLogFile> makeFree(const std::filesystem::path& path, FileCalls& calls);
  static Result<NewLogFile> makeInPlaceOf(const std::filesystem::path& path, HeldFile old,
                                          FileCalls& calls);
  static Result<NewLogFile> openAsItIs(const std::filesystem::path& path, FileCalls& calls);

  std::filesystem::path path_;     ///< the log's
  std::filesystem::path made_;     ///< the file's until it is published; empty: nothing to remove
  std::unique_ptr<HeldFile> old_;  ///< the file that it will replace
  std::unique_ptr<ByteSink> sink_;
  bool locked_ = true;
};

}  // namespace rocinante
