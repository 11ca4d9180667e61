#include "core/base/unnamed_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace rocinante {

Result<UnnamedFile> UnnamedFile::make(std::string folder) {
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) {
    // Some file systems have no O_TMPFILE.
    std::string path = folder + "/.rocinante-XXXXXX";
    file = ::mkostemp(path.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(path.c_str());
  }
  UnnamedFile made(file, std::move(folder));
  if (file < 0) return made.refusal("cannot make a temporary file");
  return made;
}

UnnamedFile::~UnnamedFile() {
  if (file_ >= 0) ::close(file_);
}

UnnamedFile::UnnamedFile(UnnamedFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), folder_(std::move(other.folder_)) {}

Error UnnamedFile::refusal(const char* what) const {
  return {ErrorKind::unreadable, std::string(what) + ": " + std::strerror(errno), folder_};
}

Status UnnamedFile::write(std::uint64_t from, ByteView bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(from + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return refusal("cannot write a temporary file");
    done += static_cast<std::size_t>(count);
  }
  return {};
}

Status UnnamedFile::read(std::uint64_t from, std::span<std::byte> out) const {
  for (std::size_t done = 0; done < out.size();) {
    const ssize_t count =
        ::pread(file_, out.data() + done, out.size() - done, static_cast<off_t>(from + done));
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;  // somebody made it shorter
    if (count <= 0) return refusal("cannot read a temporary file");
    done += static_cast<std::size_t>(count);
  }
  return {};
}

}  // namespace rocinante
