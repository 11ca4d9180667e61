#include "viewer/detail/detail_cache.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/base/atomic_file.h"
#include "viewer/detail/detail_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".lod";
constexpr std::size_t kKeyDigits = 32;

std::optional<fs::path> absoluteFolder(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr || !fs::path(text).is_absolute()) return std::nullopt;
  return fs::path(text);
}

/// Whether the file name is ours: other files are never deleted. Includes unfinished files of a
/// killed process, whose names continue after the extension.
bool isOurs(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.size() >= kKeyDigits + kExtension.size() &&
         name.find_first_not_of("0123456789abcdef") == kKeyDigits &&
         name.compare(kKeyDigits, kExtension.size(), kExtension) == 0;
}

}  // namespace

DetailCache DetailCache::ofUser() {
  if (const auto cache = absoluteFolder("XDG_CACHE_HOME")) {
    return DetailCache(*cache / "rocinante" / "lod");
  }
  if (const auto home = absoluteFolder("HOME")) {
    return DetailCache(*home / ".cache" / "rocinante" / "lod");
  }
  return {};
}

fs::path DetailCache::fileOf(const std::string& key) const {
  return folder_ / (key + std::string(kExtension));
}

std::optional<MeshDetail> DetailCache::load(const std::string& key,
                                            const DetailInput& input) const {
  if (folder_.empty()) return std::nullopt;
  const fs::path file = fileOf(key);
  const auto content = readFile(file, most_bytes_);
  if (!content.ok()) return std::nullopt;
  auto detail = decodeDetail(bytesOf(*content), key, input);
  std::error_code ignored;
  // Mark as recently used. Fails harmlessly in a read-only folder.
  if (detail) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return detail;
}

void DetailCache::store(const std::string& key, const MeshDetail& detail) const {
  if (folder_.empty()) return;
  const Bytes bytes = encodeDetail(detail, key);
  if (bytes.size() > most_bytes_) return;
  std::error_code refused;
  fs::create_directories(folder_, refused);
  if (refused) return;
  makeRoom(bytes.size());
  // Ignore write errors: the detail is only made again next time.
  static_cast<void>(writeFileWhole(fileOf(key), bytes, true).has_value());
}

void DetailCache::makeRoom(std::uint64_t bytes) const {
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
