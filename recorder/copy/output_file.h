#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/base/unfinished_path.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// refused when something stands at `path` that is one of `inputs`, that is no file, or that
/// `overwrite` does not allow to be replaced. Looked at before the work, so that a refusal does not
/// take a minute to come.
Status checkOutput(const std::filesystem::path& path, bool overwrite,
                   std::span<const std::filesystem::path> inputs);

/// A file that appears whole or not at all: written under another name beside `path`, which it
/// gets by commit(); removed when that never comes. Not for sharing between threads.
class OutputFile {
 public:
  /// As checkOutput(); unreadable when the system will not make it.
  static Result<OutputFile> create(std::filesystem::path path, bool overwrite,
                                   std::span<const std::filesystem::path> inputs);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;

  const std::filesystem::path& path() const { return path_; }

  /// Where its bytes go; to be taken once. Its close() hands them to the disk.
  std::unique_ptr<ByteSink> takeSink() { return std::move(sink_); }

  /// Gives the file its name, once the sink is closed. Looks again whether the name is free.
  Status commit();

  /// `error` with the name that the user knows in place of the one beside it.
  Error named(Error error) const;

 private:
  OutputFile() = default;

  std::filesystem::path path_;
  std::filesystem::path beside_;
  bool overwrite_ = false;
  UnfinishedPath unfinished_;  ///< beside_; removed when the sink is gone
  std::unique_ptr<ByteSink> sink_;
};

}  // namespace rocinante
