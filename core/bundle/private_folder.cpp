#include "core/bundle/private_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>
#include <system_error>
#include <utility>

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "rocinante-cell-";
constexpr const char* kLockName = ".lock";
// A folder younger than this may not be locked yet and must not be taken for abandoned.
constexpr std::time_t kYoungSeconds = 60;

/// True when the folder is ours, older than a minute, and no process holds its lock.
bool isAbandoned(const fs::path& folder) {
  struct stat facts {};
  if (::lstat(folder.c_str(), &facts) != 0 || !S_ISDIR(facts.st_mode)) return false;
  if (facts.st_uid != ::geteuid() || std::time(nullptr) - facts.st_mtime < kYoungSeconds) {
    return false;
  }
  const int lock = ::open((folder / kLockName).c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (lock < 0) return false;
  const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  ::close(lock);
  return free;
}

void removeAbandoned(const fs::path& below) {
  std::error_code error;
  for (fs::directory_iterator each(below, error), end; !error && each != end;
       each.increment(error)) {
    std::error_code ignored;
    const std::string name = each->path().filename().string();
    if (name.starts_with(kPrefix) && isAbandoned(each->path())) {
      fs::remove_all(each->path(), ignored);
    }
  }
}

}  // namespace

PrivateFolder::PrivateFolder(fs::path path, int lock) : path_(std::move(path)), lock_(lock) {}

Result<std::shared_ptr<const PrivateFolder>> PrivateFolder::make() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  const fs::path below = error ? fs::path() : fs::canonical(temporary, error);
  if (error) {
    return Error{ErrorKind::refused, "there is no folder for temporary files (TMPDIR)",
                 temporary.string()};
  }
  removeAbandoned(below);
  std::string name = (below / kPrefix).string() + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    return Error{ErrorKind::refused,
                 std::string("cannot make a folder for the log's cell: ") + std::strerror(errno),
                 below.string()};
  }
  const fs::path path = name;
  const int lock = ::open((path / kLockName).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  // Without a lock the folder is simply never taken for abandoned.
  if (lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) != 0) ::unlink((path / kLockName).c_str());
  return std::shared_ptr<const PrivateFolder>(new PrivateFolder(path, lock));
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace rocinante
