#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/file_lock.h"
#include "core/base/part_file.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kLeastPartBytes = 4096;
constexpr std::uint64_t kMostPartBytes = 256 << 10;

Error systemError(std::string what, const std::filesystem::path& path) {
  const int code = errno;
  const ErrorKind kind = code == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable;
  return {kind, std::move(what) + ": " + std::strerror(code), path.string()};
}

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

Status writeAll(int file, ByteView bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return systemError("cannot write", path);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::uint64_t max_bytes) {
  std::string content;
  const Status read = readFileInParts(path, max_bytes, [&](ByteView part, std::uint64_t size) {
    content.reserve(static_cast<std::size_t>(size));
    content.append(reinterpret_cast<const char*>(part.data()), part.size());
    return Status{};
  });
  if (!read) return read.error();
  return content;
}

Status readFileInParts(const std::filesystem::path& path, std::uint64_t max_bytes,
                       const std::function<Status(ByteView, std::uint64_t)>& take) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.number < 0) return systemError("cannot open", path);
  struct stat facts {};
  if (::fstat(file.number, &facts) != 0) return systemError("cannot read", path);
  if (S_ISDIR(facts.st_mode)) {
    return Error{ErrorKind::unreadable, "this is a folder, not a file", path.string()};
  }
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  if (size > max_bytes) {
    return Error{ErrorKind::unsupported,
                 "the file is larger than the limit of " + std::to_string(max_bytes) + " bytes",
                 path.string()};
  }
  Bytes part(std::clamp<std::uint64_t>(size + 1, kLeastPartBytes, kMostPartBytes));
  std::uint64_t total = 0;
  while (true) {
    const ssize_t got = ::read(file.number, part.data(), part.size());
    if (got < 0) {
      if (errno == EINTR) continue;
      return systemError("cannot read", path);
    }
    if (got == 0) return {};
    total += static_cast<std::uint64_t>(got);
    if (total > max_bytes) {
      return Error{ErrorKind::unsupported, "the file grew too large while it was read",
                   path.string()};
    }
    const ByteView taken = ByteView(part).first(static_cast<std::size_t>(got));
    if (Status goes_on = take(taken, size); !goes_on) return goes_on;
  }
}

Status mayWriteFile(const std::filesystem::path& path, bool overwrite) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(path, ignored);
  if (ignored == std::errc::filename_too_long) {
    errno = ENAMETOOLONG;
    return systemError("cannot create", path);
  }
  if (!overwrite && !std::filesystem::exists(there) &&
      std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))) {
    return Error{ErrorKind::refused, "a link to nothing has this name; --force overwrites it",
                 path.string()};
  }
  if (std::filesystem::exists(there)) {
    if (!std::filesystem::is_regular_file(there)) {
      return Error{ErrorKind::refused, "this is not a regular file, so it is not replaced",
                   path.string()};
    }
    if (!overwrite) {
      return Error{ErrorKind::refused, "the file exists; --force overwrites it", path.string()};
    }
    if (Status may = mayReplace(path); !may) return may;
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return systemError("cannot create", path);
  return {};
}

Status writeFileWhole(const std::filesystem::path& path, ByteView bytes, bool overwrite,
                      Sync sync) {
  if (Status may = mayWriteFile(path, overwrite); !may) return may;
  Result<PartFile> part = PartFile::make(path);
  if (!part) return part.error();
  const Result<int> writer = part->writer();
  if (!writer) return writer.error();
  Descriptor file{*writer};
  Status written = writeAll(file.number, bytes, path);
  if (written && sync == Sync::now && ::fsync(file.number) != 0 && errno != EINVAL) {
    written = systemError("cannot write", path);
  }
  if (::close(std::exchange(file.number, -1)) != 0 && written) {
    written = systemError("cannot write", path);
  }
  return written ? part->publish(overwrite) : written;
}

Status syncFileSystem(const std::filesystem::path& folder) {
  const Descriptor opened{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (opened.number < 0) return systemError("cannot open", folder);
  if (::syncfs(opened.number) != 0) return systemError("cannot write", folder);
  return {};
}

}  // namespace rocinante
