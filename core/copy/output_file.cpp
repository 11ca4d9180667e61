#include "core/copy/output_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/mcap/file_sink.h"

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
  Result<PartFile> part = PartFile::make(output.path_, 0666);
  if (!part) {
    // "cannot create: ..."
    const std::string& what = part.error().what;
    return Error{ErrorKind::unreadable, "cannot make the log" + what.substr(what.find(':')),
                 output.path_.string()};
  }
  const Result<int> file = part->writer();
  if (!file) return file.error();
  output.beside_ = part->beside();
  output.unfinished_ = UnfinishedPath(output.beside_);
  output.sink_ = makeFileSinkOn(*file, output.beside_.string());
  output.part_ = std::make_unique<PartFile>(std::move(*part));
  return output;
}

OutputFile::OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(beside_, other.beside_);
  std::swap(part_, other.part_);
  std::swap(overwrite_, other.overwrite_);
  std::swap(unfinished_, other.unfinished_);
  std::swap(sink_, other.sink_);
  return *this;
}

Status OutputFile::commit() {
  const EndingHeld until_renamed;
  if (Status published = part_->publish(overwrite_); !published) return published;
  unfinished_.keep();
  syncFolderOf(path_);
  return {};
}

Error OutputFile::named(Error error) const {
  const std::string& beside = beside_.string();
  const std::size_t at = error.where.find(beside);
  if (at != std::string::npos) error.where.replace(at, beside.size(), path_.string());
  return error;
}

}  // namespace rocinante
