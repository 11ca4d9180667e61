#include "core/log/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace rocinante {

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const auto failed = [&](const char* doing) {
    const int number = errno;
    return Error{number == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable,
                 std::string(doing) + ": " + std::strerror(number), path.string()};
  };
  // O_NONBLOCK: a named pipe must be refused below, not waited for.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return failed("cannot open the log");
  struct stat status {};
  if (::fstat(file, &status) != 0) {
    const Error error = failed("cannot look at the log");
    ::close(file);
    return error;
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(file);
    return Error{ErrorKind::unreadable, "a log must be a plain file", path.string()};
  }
  MappedFile mapped;
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > 0) {
    void* const bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (bytes == MAP_FAILED) {
      const Error error = failed("cannot map the log");
      ::close(file);
      return error;
    }
    mapped.bytes_ = ByteView(static_cast<const std::byte*>(bytes), size);
  }
  ::close(file);
  return mapped;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) {
    ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  }
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  return *this;
}

}  // namespace rocinante
