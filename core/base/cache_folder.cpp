#include "core/base/cache_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/part_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeyDigits = 32;

std::optional<fs::path> absoluteFolder(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr || !fs::path(text).is_absolute()) return std::nullopt;
  return fs::path(text);
}

bool writeWhole(int file, ByteView bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
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

void CacheFolder::store(const std::string& key, std::initializer_list<ByteView> parts) const {
  std::uint64_t bytes = 0;
  for (const ByteView part : parts) bytes += part.size();
  if (folder_.empty() || bytes > most_bytes_) return;
  std::error_code refused;
  fs::create_directories(folder_, refused);
  if (refused) return;
  makeRoom(bytes);
  // Ignore write errors: the content is only made again next time.
  if (!mayWriteFile(fileOf(key), true)) return;
  auto file = PartFile::make(fileOf(key));
  if (!file.ok()) return;
  const auto writer = file->writer();
  if (!writer.ok()) return;
  const bool is_whole =
      std::ranges::all_of(parts, [&](ByteView part) { return writeWhole(*writer, part); });
  if (::close(*writer) == 0 && is_whole) static_cast<void>(file->publish(true).has_value());
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
