#include "core/copy/output_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/log/new_log_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

Error alreadyThere(const fs::path& path) {
  return Error{ErrorKind::refused, "the file exists; --force overwrites it", path.string()};
}

/// Makes the name survive a power cut. A folder that cannot be synced is not an error: the file
/// itself is safe.
void syncFolderOf(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

}  // namespace

Status checkOutput(const fs::path& path, bool overwrite, std::span<const fs::path> inputs) {
  if (path == "-") {
    return Error{ErrorKind::bad_argument,
                 "a log is written to a file, not to standard output: name one (./- for this name)",
                 path.string()};
  }
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return {};
  for (const fs::path& input : inputs) {
    struct stat facts {};
    if (::stat(input.c_str(), &facts) == 0 && facts.st_dev == there.st_dev &&
        facts.st_ino == there.st_ino) {
      return Error{ErrorKind::refused, "the output would overwrite an input", path.string()};
    }
  }
  if (!S_ISREG(there.st_mode)) {
    return Error{ErrorKind::refused, "this is not a regular file, so it is not replaced",
                 path.string()};
  }
  if (!overwrite) return alreadyThere(path);
  return mayReplace(path);
}

Result<OutputFile> OutputFile::create(fs::path path, bool overwrite,
                                      std::span<const fs::path> inputs) {
  if (Status free = checkOutput(path, overwrite, inputs); !free) return free.error();
  OutputFile output;
  output.path_ = std::move(path);
  output.overwrite_ = overwrite;
  const fs::path beside = output.path_.string() + ".part" + std::to_string(::getpid());
  Result<NewLogFile> file = NewLogFile::make(beside, false);
  if (!file) {
    Error error = file.error();
    error.where = output.path_.string();
    return error;
  }
  output.beside_ = beside;
  output.unfinished_ = UnfinishedPath(beside);
  output.sink_ = file->takeSink();
  if (Status stays = file->publish(); !stays) return stays.error();
  return output;
}

OutputFile::OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(beside_, other.beside_);
  std::swap(overwrite_, other.overwrite_);
  std::swap(unfinished_, other.unfinished_);
  std::swap(sink_, other.sink_);
  return *this;
}

Status OutputFile::commit() {
  const EndingHeld until_renamed;
  int renamed = -1;
  const Result<HeldFile> held = HeldFile::at(path_, HeldFile::For::replacing);
  if (!held) return held.error();
  if (overwrite_) {
    renamed = ::rename(beside_.c_str(), path_.c_str());
  } else {
    renamed = ::renameat2(AT_FDCWD, beside_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE);
    // Some file systems do not support RENAME_NOREPLACE: check for an existing file instead.
    if (renamed != 0 && (errno == EINVAL || errno == ENOSYS) &&
        ::access(path_.c_str(), F_OK) != 0) {
      renamed = ::rename(beside_.c_str(), path_.c_str());
    }
  }
  if (renamed != 0) {
    if (errno == EEXIST) return alreadyThere(path_);
    return Error{ErrorKind::unreadable,
                 std::string("cannot rename the finished output: ") + std::strerror(errno),
                 path_.string()};
  }
  unfinished_.keep();
  syncFolderOf(path_);
  return {};
}

Error OutputFile::named(Error error) const {
  const std::string beside = path_.string() + ".part" + std::to_string(::getpid());
  const std::size_t at = error.where.find(beside);
  if (at != std::string::npos) error.where.replace(at, beside.size(), path_.string());
  return error;
}

}  // namespace rocinante
