#pragma once

#include <cstddef>
#include <string>

namespace rocinante {

/// Bytes under a file name, for libraries that read and write nothing else. In memory.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void append(const void* bytes, std::size_t size);
  /// All of it in memory for free(); null when it cannot be had or is empty.
  void* takeBytes(std::size_t& size) const;
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

}  // namespace rocinante
