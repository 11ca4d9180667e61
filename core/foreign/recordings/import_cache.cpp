#include "core/foreign/recordings/import_cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/cache_folder.h"
#include "core/base/file_lock.h"
#include "core/base/unfinished_path.h"
#include "core/foreign/recordings/file_digest.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLogEnding = ".mcap";
constexpr const char* kSumEnding = ".sum";
constexpr const char* kLockEnding = ".lock";
/// What a person wrote is never deleted: the marks of a log that was viewed (core/session/marks.h).
constexpr const char* kMarksEnding = ".marks";
constexpr std::size_t kKeyDigits = 64;
constexpr std::uint64_t kMaxSumBytes = 256;
constexpr auto kBetweenLooks = std::chrono::milliseconds(50);

/// Whether the folder is this user's own, and not write-protected; also for root, who may write
/// everywhere.
bool mayLieIn(const fs::path& folder) {
  struct stat facts {};
  if (::stat(folder.c_str(), &facts) != 0 || !S_ISDIR(facts.st_mode)) return false;
  return facts.st_uid == ::geteuid() && (facts.st_mode & S_IWUSR) != 0 &&
         ::access(folder.c_str(), W_OK) == 0;
}

/// What another user could have put there is not trusted.
bool isOurFile(const fs::path& file) {
  struct stat facts {};
  return ::lstat(file.c_str(), &facts) == 0 && S_ISREG(facts.st_mode) &&
         facts.st_uid == ::geteuid();
}

/// The key in the name of a file of ours: other files are never deleted. The files of a killed
/// process have names that continue after the ending.
std::string keyOf(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.size() <= kKeyDigits || name[kKeyDigits] != '.' ||
      name.find_first_not_of("0123456789abcdef") != kKeyDigits) {
    return {};
  }
  return name.substr(0, kKeyDigits);
}

Error systemError(const char* what, const fs::path& path) {
  return {ErrorKind::unreadable, std::string(what) + ": " + std::strerror(errno), path.string()};
}

/// The lock of one key. Its file is deleted by the last who holds it.
class KeyLock {
 public:
  static Result<KeyLock> take(const fs::path& path, const ImportCache::Waiting& waiting) {
    while (true) {
      const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
      if (file < 0) return systemError("cannot create a file there", path);
      KeyLock lock(file, path);
      while (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EINTR) continue;
        // Without locks two processes may make the same log; each appears whole.
        if (errno != EWOULDBLOCK) return lock;
        lock.path_.clear();  // it is another's to delete
        if (Status goes_on = waiting(); !goes_on) return goes_on.error();
        std::this_thread::sleep_for(kBetweenLooks);
      }
      lock.path_ = path;
      if (isOpenFile(path, file)) {
        lock.unfinished_ = UnfinishedPath(path);
        return lock;
      }
      lock.path_.clear();
    }
  }

  ~KeyLock() {
    if (file_ < 0) return;
    if (!path_.empty()) ::unlink(path_.c_str());
    unfinished_.keep();  // from here on it may be another's
    ::close(file_);
  }
  KeyLock(KeyLock&& other) noexcept
      : file_(other.file_),
        path_(std::move(other.path_)),
        unfinished_(std::move(other.unfinished_)) {
    other.file_ = -1;
  }
  KeyLock& operator=(KeyLock&&) = delete;

 private:
  KeyLock(int file, fs::path path) : file_(file), path_(std::move(path)) {}
  int file_;
  fs::path path_;
  UnfinishedPath unfinished_;
};

}  // namespace

std::optional<ImportCache> ImportCache::ofUser() {
  fs::path folder = CacheFolder::ofUser("imports");
  if (folder.empty()) return std::nullopt;
  return ImportCache(std::move(folder));
}

fs::path ImportCache::fileOf(const std::string& key, const char* extension) const {
  return folder_ / (key + extension);
}

Status ImportCache::openFolder() const {
  std::error_code fault;
  fs::create_directories(folder_, fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot make the folder: " + fault.message(),
                 folder_.string()};
  }
  if (!mayLieIn(folder_)) {
    return Error{ErrorKind::refused, "the folder is write-protected, or another user's",
                 folder_.string()};
  }
  return {};
}

std::optional<fs::path> ImportCache::find(const std::string& key) const {
  const fs::path log = fileOf(key, kLogEnding);
  if (!mayLieIn(folder_) || !isOurFile(log)) return std::nullopt;
  const fs::path sum_file = fileOf(key, kSumEnding);
  if (!isOurFile(sum_file)) return std::nullopt;
  const Result<std::string> sum = readFile(sum_file, kMaxSumBytes);
  if (!sum) return std::nullopt;
  const Result<std::string> now = quickSumOf(log);
  if (!now || *now != *sum) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(log, fs::file_time_type::clock::now(), ignored);
  return log;
}

Result<ImportCache::Made> ImportCache::findOrMake(const std::string& key, const Make& make,
                                                  const Waiting& waiting) const {
  if (Status open = openFolder(); !open) return Made{{}, open.error()};
  const fs::path log = fileOf(key, kLogEnding);
  const Result<KeyLock> lock = KeyLock::take(fileOf(key, kLockEnding), waiting);
  if (!lock) {
    if (lock.error().where.starts_with(folder_.string())) return Made{{}, lock.error()};
    return lock.error();
  }
  if (const auto found = find(key)) return Made{*found, std::nullopt};
  // A damaged one, or one without its sum.
  std::error_code ignored;
  fs::remove(fileOf(key, kSumEnding), ignored);
  fs::remove(log, ignored);
  UnfinishedPath unfinished(log);
  if (Status made = make(log); !made) {
    const bool is_folders = made.error().where.starts_with(folder_.string());
    return is_folders ? Result<Made>(Made{{}, made.error()}) : Result<Made>(made.error());
  }
  const Result<std::string> sum = quickSumOf(log);
  const Status noted =
      sum ? writeFileWhole(fileOf(key, kSumEnding), bytesOf(*sum), true) : Status(sum.error());
  if (!noted) return Made{{}, noted.error()};
  unfinished.keep();
  makeRoom(key);
  return Made{log, std::nullopt};
}

void ImportCache::makeRoom(const std::string& kept_key) const {
  struct Kept {
    fs::file_time_type used{};
    std::vector<fs::path> files;
    std::uint64_t bytes = 0;
  };
  std::map<std::string, Kept> by_key;
  std::uint64_t total = 0;
  std::error_code fault;
  for (fs::directory_iterator at(folder_, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code gone;
    const std::string key = keyOf(at->path());
    if (key.empty() || !at->is_regular_file(gone)) continue;
    const std::uint64_t size = at->file_size(gone);
    const auto used = at->last_write_time(gone);
    if (gone) continue;
    Kept& kept = by_key[key];
    kept.used = kept.files.empty() ? used : std::max(kept.used, used);
    kept.files.push_back(at->path());
    kept.bytes += size;
    total += size;
  }
  by_key.erase(kept_key);
  std::vector<const Kept*> oldest;
  for (const auto& [key, kept] : by_key) oldest.push_back(&kept);
  std::ranges::stable_sort(oldest, {}, [](const Kept* each) { return each->used; });
  for (const Kept* each : oldest) {
    if (total <= most_bytes_) return;
    for (const fs::path& file : each->files) {
      // Who reads it keeps it.
      if (file.extension() != kLockEnding && file.extension() != kMarksEnding) {
        fs::remove(file, fault);
      }
    }
    total -= each->bytes;
  }
}

}  // namespace rocinante
