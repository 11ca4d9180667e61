#include "viewer/ui/live/kept_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr char kLockName[] = "window.lock";
constexpr auto kStarting = std::chrono::minutes(1);

std::optional<fs::path> absoluteFolder(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr || !fs::path(text).is_absolute()) return std::nullopt;
  return fs::path(text);
}

/// The lock of a folder, held until the descriptor is closed; -1 when it cannot be taken.
int takeLock(const fs::path& folder) {
  const int file = ::open((folder / kLockName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return file;
  ::close(file);
  return -1;
}

/// A folder's name is ours: others are never touched.
bool isOurs(const fs::path& folder) { return folder.filename().string().starts_with("session-"); }

}  // namespace

fs::path KeptFolder::ofUser() {
  if (const auto cache = absoluteFolder("XDG_CACHE_HOME")) return *cache / "rocinante" / "live";
  if (const auto home = absoluteFolder("HOME")) return *home / ".cache" / "rocinante" / "live";
  return {};
}

Result<KeptFolder> KeptFolder::make(const fs::path& parent) {
  if (parent.empty()) {
    return Error{ErrorKind::bad_argument, "neither XDG_CACHE_HOME nor HOME names a folder", {}};
  }
  std::error_code fault;
  fs::create_directories(parent, fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot make the folder: " + fault.message(),
                 parent.string()};
  }
  std::string name = (parent / "session-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    return Error{ErrorKind::unreadable,
                 std::string("cannot make a folder there: ") + std::strerror(errno),
                 parent.string()};
  }
  const int lock = takeLock(name);
  if (lock < 0) {
    fs::remove_all(name, fault);
    return Error{ErrorKind::unreadable, "cannot create a file there", name};
  }
  return KeptFolder(name, lock);
}

std::vector<KeptLeftover> KeptFolder::leftovers(const fs::path& parent) {
  std::vector<std::pair<fs::file_time_type, KeptLeftover>> found;
  std::error_code fault;
  for (fs::directory_iterator each(parent, fault), end; !fault && each != end;
       each.increment(fault)) {
    std::error_code ignored;
    if (!isOurs(each->path()) || !each->is_directory(ignored)) continue;
    const int lock = takeLock(each->path());
    if (lock < 0) continue;
    KeptLeftover one;
    one.folder = each->path();
    for (fs::directory_iterator file(one.folder, ignored); !ignored && file != end;
         file.increment(ignored)) {
      if (file->path().extension() != ".mcap") continue;
      one.pieces.push_back(file->path());
      one.bytes += file->file_size(ignored);
    }
    std::ranges::sort(one.pieces);
    if (one.pieces.empty()) {
      // A window that has just started may not have locked its folder yet.
      const auto age = fs::file_time_type::clock::now() - fs::last_write_time(one.folder, ignored);
      if (!ignored && age > kStarting) fs::remove_all(one.folder, ignored);
    } else {
      found.emplace_back(fs::last_write_time(one.pieces.back(), ignored), std::move(one));
    }
    ::close(lock);
  }
  std::ranges::sort(found, {}, [](const auto& each) { return each.first; });
  std::vector<KeptLeftover> leftovers;
  for (auto& [time, leftover] : found) leftovers.push_back(std::move(leftover));
  return leftovers;
}

Status KeptFolder::forget(const KeptLeftover& leftover) {
  const int lock = takeLock(leftover.folder);
  if (lock < 0) {
    return Error{ErrorKind::refused, "another program is using it", leftover.folder.string()};
  }
  std::error_code fault;
  fs::remove_all(leftover.folder, fault);
  ::close(lock);
  if (!fault) return {};
  return Error{ErrorKind::unreadable, "cannot delete it: " + fault.message(),
               leftover.folder.string()};
}

KeptFolder::~KeptFolder() {
  if (lock_ < 0) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::close(lock_);
}

KeptFolder::KeptFolder(KeptFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

std::string leftoversOffer(const std::vector<KeptLeftover>& leftovers) {
  if (leftovers.empty()) return {};
  std::uint64_t bytes = 0;
  for (const KeptLeftover& each : leftovers) bytes += each.bytes;
  return fmt::format(
      "{} of windows that were killed, {}, can still be saved: rocinante view --leftovers",
      countText(leftovers.size(), "live session"), sizeText(bytes));
}

std::string leftoversText(const std::vector<KeptLeftover>& leftovers) {
  if (leftovers.empty()) return "no live session was left behind\n";
  std::string text;
  for (const KeptLeftover& each : leftovers) {
    text += fmt::format("{}  {}, {}\n", each.folder.string(), countText(each.pieces.size(), "log"),
                        sizeText(each.bytes));
  }
  text +=
      "to save one: rocinante log merge FOLDER/*.mcap -o session.mcap (rocinante log recover for a "
      "single log)\n"
      "to delete all of them: rocinante view --forget-leftovers\n";
  return text;
}

}  // namespace rocinante
