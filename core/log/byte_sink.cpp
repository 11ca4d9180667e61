#include "core/log/byte_sink.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rocinante {
namespace {

Error systemError(const std::string& doing, int number, const std::string& name) {
  return Error{ErrorKind::unreadable, doing + ": " + std::strerror(number), name};
}

class FileSink final : public ByteSink {
 public:
  FileSink(int file, std::string name) : file_(file), name_(std::move(name)) {}
  ~FileSink() override {
    if (file_ >= 0) ::close(file_);
  }
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  Status append(ByteView bytes) override { return writeAll(file_, bytes, name_, ::write); }

  Status truncate(std::uint64_t size_bytes) override {
    const auto size = static_cast<off_t>(size_bytes);
    if (::ftruncate(file_, size) != 0 || ::lseek(file_, size, SEEK_SET) != size) {
      return systemError("cannot take back an unfinished write", errno, name_);
    }
    return {};
  }

  Status close() override {
    // EINVAL: a pipe or a device, which has nothing to sync.
    const int sync_error = ::fdatasync(file_) == 0 || errno == EINVAL ? 0 : errno;
    // Never called again after EINTR: the descriptor is gone all the same on Linux.
    const int close_error = ::close(std::exchange(file_, -1)) == 0 || errno == EINTR ? 0 : errno;
    if (sync_error != 0) return systemError("cannot hand the log to the disk", sync_error, name_);
    if (close_error != 0) return systemError("cannot close the log", close_error, name_);
    return {};
  }

  const std::string& name() const override { return name_; }

 private:
  int file_;
  std::string name_;
};

class MemorySink final : public ByteSink {
 public:
  explicit MemorySink(Bytes& out) : out_(out) {}

  Status append(ByteView bytes) override {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return {};
  }
  Status truncate(std::uint64_t size_bytes) override {
    out_.resize(static_cast<std::size_t>(size_bytes));
    return {};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  Bytes& out_;
  std::string name_ = "memory";
};

}  // namespace

Status writeAll(int file, ByteView bytes, const std::string& name, const WriteFunction& write) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return systemError("cannot write to the log", errno, name);
    }
    // A write of nothing that is no error would go on for ever.
    if (written == 0) return systemError("cannot write to the log", ENOSPC, name);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<std::unique_ptr<ByteSink>> makeFileSink(const std::filesystem::path& path, bool overwrite) {
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (overwrite ? O_TRUNC : O_EXCL);
  int file = -1;
  do {
    file = ::open(path.c_str(), flags, 0666);
  } while (file < 0 && errno == EINTR);
  if (file < 0) {
    if (errno == EEXIST) {
      return Error{ErrorKind::refused, "the file exists already and is not overwritten",
                   path.string()};
    }
    return systemError("cannot make the log", errno, path.string());
  }
  return std::unique_ptr<ByteSink>(std::make_unique<FileSink>(file, path.string()));
}

std::unique_ptr<ByteSink> makeMemorySink(Bytes& out) { return std::make_unique<MemorySink>(out); }

}  // namespace rocinante
