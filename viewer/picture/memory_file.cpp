#include "viewer/picture/memory_file.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace rocinante {

MemoryFile::MemoryFile() : file_(::memfd_create("picture", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (file_ >= 0) ::close(file_);
}

void MemoryFile::append(const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(file_, next, size);
    if (written <= 0) break;
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void* MemoryFile::takeBytes(std::size_t& size) const {
  struct stat facts {};
  if (::fstat(file_, &facts) != 0 || facts.st_size <= 0) return nullptr;
  size = static_cast<std::size_t>(facts.st_size);
  auto* bytes = static_cast<char*>(std::malloc(size));
  for (std::size_t done = 0; bytes != nullptr && done < size;) {
    const ssize_t count = ::pread(file_, bytes + done, size - done, static_cast<off_t>(done));
    if (count <= 0) {
      std::free(bytes);
      return nullptr;
    }
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace rocinante
