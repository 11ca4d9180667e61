#include "core/log/followed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rocinante {
namespace {

Error systemError(const std::string& doing, const std::string& name) {
  const ErrorKind kind = errno == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable;
  return Error{kind, doing + ": " + std::strerror(errno), name};
}

class SystemFile final : public FollowedFile {
 public:
  SystemFile(int file, std::string name) : file_(file), name_(std::move(name)) {}
  ~SystemFile() override { ::close(file_); }
  SystemFile(const SystemFile&) = delete;
  SystemFile& operator=(const SystemFile&) = delete;

  Result<std::uint64_t> size() override {
    struct stat mine {};
    if (::fstat(file_, &mine) != 0) return systemError("cannot read the file", name_);
    struct stat named {};
    if (::stat(name_.c_str(), &named) == 0 &&
        (named.st_dev != mine.st_dev || named.st_ino != mine.st_ino)) {
      return Error{ErrorKind::unreadable, "another file replaced the one that is followed", name_};
    }
    return static_cast<std::uint64_t>(mine.st_size);
  }

  Status read(std::uint64_t offset, std::span<std::byte> out) override {
    while (!out.empty()) {
      const ssize_t got = ::pread(file_, out.data(), out.size(), static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return systemError("cannot read the file", name_);
      if (got == 0) {
        return Error{ErrorKind::unreadable, "the file was truncated while it was read", name_};
      }
      offset += static_cast<std::uint64_t>(got);
      out = out.subspan(static_cast<std::size_t>(got));
    }
    return {};
  }

  const std::string& name() const override { return name_; }

 private:
  int file_;
  std::string name_;
};

}  // namespace

Result<std::unique_ptr<FollowedFile>> followFile(const std::filesystem::path& path) {
  // O_NONBLOCK: opening a pipe would wait for its writer.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return systemError("cannot open", path.string());
  auto followed = std::make_unique<SystemFile>(file, path.string());
  struct stat facts {};
  if (::fstat(file, &facts) != 0) return systemError("cannot read the file", path.string());
  if (!S_ISREG(facts.st_mode)) {
    return Error{ErrorKind::unreadable, "only a regular file can be followed", path.string()};
  }
  return std::unique_ptr<FollowedFile>(std::move(followed));
}

}  // namespace rocinante
