#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>

#include "core/base/file_lock.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// The system calls of a FileSink, as values: tests pass in a system that is interrupted, writes
/// half, is full, or loses its disk.
struct FileCalls {
  std::function<ssize_t(int, const void*, std::size_t)> write;
  std::function<ssize_t(int, const void*, std::size_t, off_t)> pwrite;
  std::function<int(int, off_t)> ftruncate;
  std::function<int(int, int, off_t, off_t)> fallocate;
  std::function<int(int, off_t, off_t, unsigned)> sync_file_range;
  std::function<int(int)> fdatasync;
  std::function<int(int)> close;
  std::function<Result<Lock>(int, const std::filesystem::path&)> lock;  ///< lockFile()

  static FileCalls system();
};

/// A sink on an open file, which it owns. A regular file must be empty; anything else (a pipe, a
/// device) only grows. docs/log-format.md, "A disk that refuses".
std::unique_ptr<ByteSink> makeFileSinkOn(int file, std::string name,
                                         FileCalls calls = FileCalls::system());

}  // namespace rocinante
