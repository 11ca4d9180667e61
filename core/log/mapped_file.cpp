#include "core/log/mapped_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/log/foreign_file.h"

namespace rocinante {
namespace {

/// Address space costs nothing until it is used; few files grow longer.
constexpr std::uint64_t kRoomBytes = std::uint64_t{256} << 30U;

/// Whoever reads chunks accesses their heads in place, and the system pages in 64 KiB around each.
constexpr std::uint64_t kReadBeforeRelease = std::uint64_t{64} << 20U;

}  // namespace

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  return openWithRoom(path, 0);
}

Result<MappedFile> MappedFile::openGrowing(const std::filesystem::path& path) {
  return openWithRoom(path, kRoomBytes);
}

Result<MappedFile> MappedFile::openWithRoom(const std::filesystem::path& path, std::uint64_t room) {
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
    return Error{ErrorKind::unreadable, notAFile(path), path.string()};
  }
  MappedFile mapped;
  mapped.file_ = file;
  const auto size = static_cast<std::size_t>(status.st_size);
  mapped.name_ = path.string();
  if (size + room == 0) return mapped;
  // Shared: what another process appends or completes in place must be seen.
  const int sharing = room > 0 ? MAP_SHARED : MAP_PRIVATE;
  void* bytes = MAP_FAILED;
  while (true) {
    mapped.mapped_bytes_ = size + static_cast<std::size_t>(room);
    bytes = ::mmap(nullptr, mapped.mapped_bytes_, PROT_READ, sharing | MAP_NORESERVE, file, 0);
    if (bytes != MAP_FAILED || room == 0) break;
    room = room > (1U << 20U) ? room / 2 : 0;  // the system limits address space
    if (size + room == 0) return mapped;
  }
  if (bytes == MAP_FAILED) {
    mapped.mapped_bytes_ = 0;
    return failed("cannot map the log");
  }
  mapped.bytes_ = ByteView(static_cast<const std::byte*>(bytes), size);
  return mapped;
}

Result<bool> MappedFile::grow(std::uint64_t needed_bytes) {
  struct stat status {};
  if (::fstat(file_, &status) != 0) {
    return Error{ErrorKind::unreadable,
                 std::string("cannot read the log's size: ") + std::strerror(errno), name_};
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size < needed_bytes) {
    return Error{ErrorKind::unreadable, "the log was truncated while it was read", name_};
  }
  if (size > mapped_bytes_) {
    return Error{ErrorKind::unreadable,
                 "the log has grown beyond what can be followed: open it again", name_};
  }
  if (size == bytes_.size()) return false;
  bytes_ = ByteView(bytes_.data(), static_cast<std::size_t>(size));
  return true;
}

MappedFile::~MappedFile() {
  if (mapped_bytes_ > 0) ::munmap(const_cast<std::byte*>(bytes_.data()), mapped_bytes_);
  if (file_ >= 0) ::close(file_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, {})),
      mapped_bytes_(std::exchange(other.mapped_bytes_, 0)),
      name_(std::move(other.name_)),
      file_(std::exchange(other.file_, -1)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  std::swap(mapped_bytes_, other.mapped_bytes_);
  std::swap(name_, other.name_);
  std::swap(file_, other.file_);
  return *this;
}

bool MappedFile::beingWritten() const {
  while (::flock(file_, LOCK_SH | LOCK_NB) != 0) {
    if (errno != EINTR) return errno == EWOULDBLOCK;
  }
  ::flock(file_, LOCK_UN);
  return false;
}

bool MappedFile::replaced() const {
  struct stat mine {};
  struct stat named {};
  return ::fstat(file_, &mine) == 0 && ::stat(name_.c_str(), &named) == 0 &&
         (named.st_dev != mine.st_dev || named.st_ino != mine.st_ino);
}

bool MappedFile::whole() const {
  struct stat status {};
  return ::fstat(file_, &status) == 0 &&
         static_cast<std::uint64_t>(status.st_size) >= bytes_.size();
}

void MappedFile::releasePages() const {
  if (mapped_bytes_ == 0) return;
  ::madvise(const_cast<std::byte*>(bytes_.data()), bytes_.size(), MADV_DONTNEED);
}

bool MappedFile::read(std::uint64_t offset, std::span<std::byte> out) const {
  if (read_bytes_.fetch_add(out.size(), std::memory_order_relaxed) > kReadBeforeRelease) {
    read_bytes_.store(0, std::memory_order_relaxed);
    releasePages();
  }
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
