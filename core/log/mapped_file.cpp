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
  // O_NONBLOCK: a named pipe must be refused below without waiting for its writer.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return failed("cannot open the log");
  struct stat status {};
  if (::fstat(file, &status) != 0) {
    const Error error = failed("cannot read the log's size");
    ::close(file);
    return error;
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(file);
    return Error{ErrorKind::unreadable, "a log must be a regular file", path.string()};
  }
  MappedFile mapped;
  mapped.file_ = file;
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > 0) {
    void* const bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (bytes == MAP_FAILED) return failed("cannot map the log");
    mapped.bytes_ = ByteView(static_cast<const std::byte*>(bytes), size);
  }
  return mapped;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) {
    ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  }
  if (file_ >= 0) ::close(file_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, {})), file_(std::exchange(other.file_, -1)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  std::swap(file_, other.file_);
  return *this;
}

bool MappedFile::whole() const {
  struct stat status {};
  return ::fstat(file_, &status) == 0 &&
         static_cast<std::uint64_t>(status.st_size) >= bytes_.size();
}

bool MappedFile::read(std::uint64_t offset, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t count = ::pread(file_, out.data(), out.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    out = out.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  return true;
}

}  // namespace rocinante
