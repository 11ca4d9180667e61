#include "core/mcap/file_sink.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace rocinante {
namespace {

Error systemError(const std::string& doing, int number, const std::string& name) {
  return Error{ErrorKind::unreadable, doing + ": " + std::strerror(number), name};
}

/// Retries while the call is interrupted.
template <class Call>
auto uninterrupted(Call call) {
  auto answer = call();
  while (answer < 0 && errno == EINTR) answer = call();
  return answer;
}

/// True for the errors of a file system without preallocation or writeback, and of a pipe.
bool notSupported(int number) {
  return number == EOPNOTSUPP || number == ENOSYS || number == EINVAL || number == ESPIPE ||
         number == ENODEV;
}

/// The largest size that a file may reach under this process's limit.
std::uint64_t largestFile() {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return ~std::uint64_t{0};
  }
  return limit.rlim_cur;
}

class FileSink final : public ByteSink {
 public:
  FileSink(int file, std::string name, FileCalls calls)
      : file_(file), name_(std::move(name)), calls_(std::move(calls)) {
    struct stat status {};
    regular_ = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    linked_ = regular_ && status.st_nlink > 0;
    reserves_ = regular_;
  }
  ~FileSink() override {
    if (file_ >= 0) (void)close();
  }
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  Status append(ByteView bytes) override {
    // Before it grows: growing would restore the length of a truncated file.
    (void)check();
    while (!bytes.empty()) {
      const Result<std::size_t> written = regular_ ? writeAt(end_, bytes) : writeNext(bytes);
      if (!written) return written.error();
      end_ += *written;
      bytes = bytes.subspan(*written);
    }
    return {};
  }

  Status truncate(std::uint64_t size_bytes) override {
    if (size_bytes == end_) return {};
    if (Status done = setSize(size_bytes); !done) return done;
    end_ = reserved_until_ = size_bytes;
    return {};
  }

  bool overwritable() const override { return regular_; }

  Status overwriteAt(std::uint64_t offset, ByteView bytes) override {
    while (!bytes.empty()) {
      const Result<std::size_t> written = writeAt(offset, bytes);
      if (!written) return written.error();
      offset += *written;
      bytes = bytes.subspan(*written);
    }
    return {};
  }

  Status reserve(std::uint64_t size_bytes) override {
    const std::uint64_t from = std::max(end_, reserved_until_);
    if (size_bytes <= from || !regular_) return {};
    // Not every file system checks this limit before the write itself.
    if (size_bytes > largestFile()) return cannotWrite(EFBIG);
    if (!reserves_) return {};
    allocated_ahead_ = true;  // a failed call may have allocated some of it
    const int answer = uninterrupted([&] {
      return calls_.fallocate(file_, FALLOC_FL_KEEP_SIZE, static_cast<off_t>(from),
                              static_cast<off_t>(size_bytes - from));
    });
    if (answer == 0) {
      reserved_until_ = size_bytes;
      return {};
    }
    if (!notSupported(errno)) return cannotWrite(errno);
    reserves_ = false;
    return {};
  }

  Status startWriteback(std::uint64_t offset, std::uint64_t size_bytes) override {
    if (!regular_) return {};
    const int answer = uninterrupted([&] {
      return calls_.sync_file_range(file_, static_cast<off_t>(offset),
                                    static_cast<off_t>(size_bytes), SYNC_FILE_RANGE_WRITE);
    });
    if (answer == 0 || notSupported(errno)) return {};
    return systemError("cannot flush the log to the disk", errno, name_);
  }

  Status check() override {
    struct stat status {};
    if (!disturbance_ && regular_ && ::fstat(file_, &status) == 0) {
      if (linked_ && status.st_nlink == 0) {
        disturb(
            "another program deleted or replaced this log while it was written: nothing of it is "
            "left");
      } else if (static_cast<std::uint64_t>(status.st_size) != end_) {
        disturb(
            fmt::format("another program changed this log while it was written: it has {} bytes "
                        "where {} were written",
                        status.st_size, end_));
      }
    }
    if (disturbance_) return *disturbance_;
    return {};
  }

  Status close() override {
    Status outcome;
    Status undisturbed = check();
    if (allocated_ahead_) outcome = setSize(end_);
    // EINVAL: a pipe or a device, which has nothing to sync.
    if (uninterrupted([&] { return calls_.fdatasync(file_); }) != 0 && errno != EINVAL && outcome) {
      outcome = systemError("cannot flush the log to the disk", errno, name_);
    }
    // Not repeated after EINTR: on Linux the descriptor is closed all the same.
    if (calls_.close(std::exchange(file_, -1)) != 0 && errno != EINTR && outcome) {
      outcome = systemError("cannot close the log", errno, name_);
    }
    return undisturbed ? outcome : undisturbed;
  }

  const std::string& name() const override { return name_; }

 private:
  void disturb(std::string what) {
    disturbance_ = Error{ErrorKind::damaged, std::move(what), name_};
  }

  Error cannotWrite(int number) const {
    return systemError("cannot write to the file", number, name_);
  }

  Result<std::size_t> writeAt(std::uint64_t offset, ByteView bytes) {
    return counted(uninterrupted([&] {
      return calls_.pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    }));
  }
  Result<std::size_t> writeNext(ByteView bytes) {
    return counted(uninterrupted([&] { return calls_.write(file_, bytes.data(), bytes.size()); }));
  }
  Result<std::size_t> counted(ssize_t written) const {
    if (written < 0) return cannotWrite(errno);
    // A write of zero bytes without an error would be retried for ever.
    if (written == 0) return cannotWrite(ENOSPC);
    return static_cast<std::size_t>(written);
  }

  Status setSize(std::uint64_t size_bytes) {
    const auto size = static_cast<off_t>(size_bytes);
    if (uninterrupted([&] { return calls_.ftruncate(file_, size); }) == 0) return {};
    return systemError("cannot truncate the log to its size", errno, name_);
  }

  int file_;
  std::string name_;
  FileCalls calls_;
  bool regular_ = false;
  bool linked_ = false;  ///< it had a name; some file systems do not count links
  std::optional<Error> disturbance_;
  bool reserves_ = false;
  std::uint64_t end_ = 0;
  std::uint64_t reserved_until_ = 0;  ///< blocks are allocated up to here
  bool allocated_ahead_ = false;
};

}  // namespace

FileCalls FileCalls::system() {
  return {::write,           ::pwrite,    ::ftruncate, ::fallocate,
          ::sync_file_range, ::fdatasync, ::close,     lockFile};
}

std::unique_ptr<ByteSink> makeFileSinkOn(int file, std::string name, FileCalls calls) {
  return std::make_unique<FileSink>(file, std::move(name), std::move(calls));
}

}  // namespace rocinante
