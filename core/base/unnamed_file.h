#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A temporary file without a name, which is gone when this is. One thread.
class UnnamedFile {
 public:
  /// unreadable when none can be made in `folder`.
  static Result<UnnamedFile> make(std::string folder);
  ~UnnamedFile();
  UnnamedFile(UnnamedFile&& other) noexcept;
  UnnamedFile& operator=(UnnamedFile&&) = delete;

  /// All of `bytes`, to there. unreadable when the system refuses, as on a full disk.
  Status write(std::uint64_t from, ByteView bytes);
  /// By which this process can open it while this lives.
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }
  /// As many bytes as `out` has, from there.
  Status read(std::uint64_t from, std::span<std::byte> out) const;

 private:
  UnnamedFile(int file, std::string folder) : file_(file), folder_(std::move(folder)) {}
  Error refusal(const char* what) const;

  int file_;
  std::string folder_;
};

}  // namespace rocinante
