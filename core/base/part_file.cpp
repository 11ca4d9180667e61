#include "core/base/part_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/random_id.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".part~";
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::size_t kRandomLetters = 6;
constexpr std::size_t kNameBytes = NAME_MAX - kMark.size() - kRandomLetters;
// Each fails only when the name is taken, or another process took the new file for a leftover.
constexpr int kMaxTries = 100;

Error cannotCreate(const fs::path& path, int number) {
  const ErrorKind kind = number == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable;
  return {kind, std::string("cannot create: ") + std::strerror(number), path.string()};
}

std::string randomLetters() {
  std::string letters;
  std::uint64_t number = randomNumber();
  for (std::size_t i = 0; i < kRandomLetters; ++i, number /= kLetters.size()) {
    letters += kLetters[number % kLetters.size()];
  }
  return letters;
}

bool isPartName(std::string_view name) {
  if (name.size() <= kMark.size() + kRandomLetters) return false;
  const std::string_view letters = name.substr(name.size() - kRandomLetters);
  name.remove_suffix(kRandomLetters);
  return name.ends_with(kMark) && letters.find_first_not_of(kLetters) == letters.npos;
}

void removeIfLeft(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return;
  struct stat facts {};
  const bool is_left = ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) &&
                       facts.st_uid == ::geteuid() && ::flock(file, LOCK_EX | LOCK_NB) == 0;
  if (is_left && isOpenFile(path, file)) ::unlink(path.c_str());
  ::close(file);
}

/// The parts that a folder had when this process first made one there: a folder of many thousand
/// outputs is read once.
void removeLeftovers(const fs::path& folder, const std::string& begin) {
  static std::mutex together;
  static std::map<fs::path, std::set<std::string>> found_in;
  const std::lock_guard alone(together);
  const auto [found, is_new] = found_in.try_emplace(folder);
  std::set<std::string>& names = found->second;
  std::error_code error;
  if (is_new) {
    for (fs::directory_iterator each(folder, error), end; !error && each != end;
         each.increment(error)) {
      std::string name = each->path().filename().string();
      if (isPartName(name)) names.insert(std::move(name));
    }
  }
  for (auto name = names.lower_bound(begin); name != names.end() && name->starts_with(begin);) {
    if (name->size() == begin.size() + kRandomLetters) removeIfLeft(folder / *name);
    name = names.erase(name);
  }
}

/// As rename(), but never over another file; where a file system cannot do that, by a second name.
int renameToFree(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  if (::link(from.c_str(), to.c_str()) == 0) return ::unlink(from.c_str());
  if (errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS) return -1;
  // FAT has neither.
  struct stat facts {};
  if (::lstat(to.c_str(), &facts) != 0) return ::rename(from.c_str(), to.c_str());
  errno = EEXIST;
  return -1;
}

}  // namespace

fs::path partPath(const fs::path& path, std::string_view six) {
  std::string name = path.filename().string();
  if (name.size() > kNameBytes) {
    std::size_t end = kNameBytes;
    // Not within a character of UTF-8.
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
    name.resize(end);
  }
  fs::path beside = path;
  return beside.replace_filename(name + std::string(kMark) + std::string(six));
}

Result<PartFile> PartFile::make(const fs::path& path, mode_t mode) {
  struct stat facts {};
  // A name that is too long is refused now, not when all is written.
  if (::lstat(path.c_str(), &facts) != 0 && errno == ENAMETOOLONG) return cannotCreate(path, errno);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  removeLeftovers(folder, partPath(path, "").filename().string());
  int number = EEXIST;
  for (int attempt = 0; attempt < kMaxTries && number == EEXIST; ++attempt) {
    PartFile part;
    part.path_ = path;
    const fs::path beside = partPath(path, randomLetters());
    part.file_ = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    number = part.file_ < 0 ? errno : 0;
    if (number == EINTR) number = EEXIST;
    if (part.file_ < 0) continue;
    part.beside_ = beside;
    // Without locks on this file system nobody can tell it from a leftover, and it is left alone.
    if (lockFile(part.file_, beside).ok() && isOpenFile(beside, part.file_)) return part;
    number = EEXIST;
  }
  return cannotCreate(path, number);
}

Result<PartFile> PartFile::makeFolder(const fs::path& path) {
  int number = EEXIST;
  for (int attempt = 0; attempt < kMaxTries && number == EEXIST; ++attempt) {
    PartFile part;
    part.path_ = path;
    part.is_folder_ = true;
    const fs::path beside = partPath(path, randomLetters());
    number = ::mkdir(beside.c_str(), 0777) == 0 ? 0 : errno;
    if (number != 0) continue;
    part.beside_ = beside;
    return part;
  }
  return cannotCreate(path, number);
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!beside_.empty() && is_folder_) fs::remove_all(beside_, ignored);
  if (!beside_.empty() && !is_folder_) ::unlink(beside_.c_str());
  if (file_ >= 0) ::close(file_);
}

PartFile::PartFile(PartFile&& other) noexcept { swap(other); }

PartFile& PartFile::operator=(PartFile&& other) noexcept {
  swap(other);
  return *this;
}

void PartFile::swap(PartFile& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(beside_, other.beside_);
  std::swap(file_, other.file_);
  std::swap(is_folder_, other.is_folder_);
}

Result<int> PartFile::writer() const {
  const int file = ::fcntl(file_, F_DUPFD_CLOEXEC, 0);
  if (file < 0) return cannotCreate(path_, errno);
  return file;
}

Status PartFile::publish(bool overwrite) {
  // Held during the replacement, so that no recorder begins to write the file being replaced.
  const Result<HeldFile> held = HeldFile::at(path_, HeldFile::For::replacing);
  if (!held) return held.error();
  if (is_folder_ || overwrite) return publishOver(*held);
  if (renameToFree(beside_, path_) != 0) {
    if (errno != EEXIST) return cannotCreate(path_, errno);
    return Error{ErrorKind::refused, "the file exists; --force overwrites it", path_.string()};
  }
  published();
  return {};
}

Status PartFile::publishOver(const HeldFile&) {
  if (::rename(beside_.c_str(), path_.c_str()) != 0) return cannotCreate(path_, errno);
  published();
  return {};
}

void PartFile::published() {
  beside_.clear();
  // It is complete: who replaces it next need not wait until this process gets to close it. Not
  // before it has its name: the lock is given up for a moment, in which a part looks left over.
  if (file_ >= 0) static_cast<void>(::flock(file_, LOCK_SH));
}

}  // namespace rocinante
