#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/part_file.h"
#include "core/base/result.h"
#include "core/base/unfinished_path.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// refused when `path` exists and is one of `inputs`, is not a regular file, or may not be replaced
/// without `overwrite`. Called before the work, so that the refusal comes at once.
Status checkOutput(const std::filesystem::path& path, bool overwrite,
                   std::span<const std::filesystem::path> inputs);

/// A file that appears whole or not at all: written under another name beside `path`, renamed by
/// commit(), and removed without it. Not for sharing between threads.
class OutputFile {
 public:
  /// Fails as checkOutput(); unreadable when the file cannot be created.
  static Result<OutputFile> create(std::filesystem::path path, bool overwrite,
                                   std::span<const std::filesystem::path> inputs);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;

  const std::filesystem::path& path() const { return path_; }

  /// The sink for the file's bytes; take it once. Its close() syncs them to the disk.
  std::unique_ptr<ByteSink> takeSink() { return std::move(sink_); }

  /// Renames the file after the sink is closed. Checks again that the name is free.
  Status commit();

  /// `error` with the user's file name instead of the temporary one.
  Error named(Error error) const;

 private:
  OutputFile() = default;

  std::filesystem::path path_;
  std::filesystem::path beside_;  ///< the name until commit()
  bool overwrite_ = false;
  UnfinishedPath unfinished_;  ///< beside_; removed after the sink is destroyed
  std::unique_ptr<PartFile> part_;
  std::unique_ptr<ByteSink> sink_;
};

}  // namespace rocinante
