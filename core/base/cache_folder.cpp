#include "core/base/cache_folder.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

#include "core/base/atomic_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeyDigits = 32;

std::optional<fs::path> absoluteFolder(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr || !fs::path(text).is_absolute()) return std::nullopt;
  return fs::path(text);
}

}  // namespace

fs::path CacheFolder::ofUser(const std::string& name) {
  if (const auto cache = absoluteFolder("XDG_CACHE_HOME")) return *cache / "rocinante" / name;
  if (const auto home = absoluteFolder("HOME")) return *home / ".cache" / "rocinante" / name;
  return {};
}

/// By its name, which includes unfinished files of a killed process: those continue after the
/// ending.
bool CacheFolder::isOurs(const fs::path& file) const {
  const std::string name = file.filename().string();
  return name.size() >= kKeyDigits + ending_.size() &&
         name.find_first_not_of("0123456789abcdef") == kKeyDigits &&
         name.compare(kKeyDigits, ending_.size(), ending_) == 0;
}

void CacheFolder::touch(const std::string& key) const {
  std::error_code ignored;
  fs::last_write_time(fileOf(key), fs::file_time_type::clock::now(), ignored);
}

void CacheFolder::store(const std::string& key, ByteView bytes) const {
  if (folder_.empty() || bytes.size() > most_bytes_) return;
  std::error_code refused;
  fs::create_directories(folder_, refused);
  if (refused) return;
  makeRoom(bytes.size());
  // Ignore write errors: the content is only made again next time.
  static_cast<void>(writeFileWhole(fileOf(key), bytes, true, Sync::later).has_value());
}

void CacheFolder::makeRoom(std::uint64_t bytes) const {
  struct Kept {
    fs::file_time_type used;
    fs::path file;
    std::uint64_t bytes;
  };
  std::vector<Kept> kept;
  std::uint64_t total = bytes;
  std::error_code fault;
  for (fs::directory_iterator at(folder_, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code gone;
    if (!isOurs(at->path()) || !at->is_regular_file(gone)) continue;
    const std::uint64_t size = at->file_size(gone);
    const auto used = at->last_write_time(gone);
    if (gone) continue;
    total += size;
    kept.push_back({used, at->path(), size});
  }
  std::ranges::sort(kept, [](const Kept& a, const Kept& b) {
    return a.used != b.used ? a.used < b.used : a.file < b.file;
  });
  for (const Kept& oldest : kept) {
    if (total <= most_bytes_) return;
    if (fs::remove(oldest.file, fault)) total -= oldest.bytes;
  }
}

}  // namespace rocinante
