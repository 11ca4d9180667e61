#pragma once

#include <filesystem>
#include <fstream>

#include "tests/core/log/write_history.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// A file that is changed in place, as a recorder does.
class GrowingFile {
 public:
  GrowingFile() : path_(folder_ / "growing.mcap") { std::ofstream(path_, std::ios::binary); }
  explicit GrowingFile(const Bytes& content) : GrowingFile() { append(content); }

  void apply(const WriteHistory::Write& write) {
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    if (write.offset) {
      file.seekp(static_cast<std::streamoff>(*write.offset));
    } else {
      file.seekp(0, std::ios::end);
    }
    file.write(reinterpret_cast<const char*>(write.bytes.data()),
               static_cast<std::streamsize>(write.bytes.size()));
  }
  void append(const Bytes& bytes) { apply({std::nullopt, bytes}); }
  void cutTo(std::size_t size) { std::filesystem::resize_file(path_, size); }
  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

}  // namespace rocinante::test
