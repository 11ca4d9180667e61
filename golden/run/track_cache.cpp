#include "golden/run/track_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/kinematics/kinematics.h"
#include "core/log/mapped_file.h"
#include "golden/run/track_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTrackExtension = ".track";
/// Goes into keys: to be raised when tracks are made otherwise.
constexpr int kTrackVersion = 2;

bool isTrackFile(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.size() >= 32 + kTrackExtension.size() &&
         name.find_first_not_of("0123456789abcdef") == 32 &&
         name.compare(32, kTrackExtension.size(), kTrackExtension) == 0;
}

}  // namespace

std::string trackCellHash(const Cell& cell) {
  std::string text;
  for (const CellDevice& device : cell.devices) {
    const Model* model = cell.modelOf(device);
    const Pose& pose = device.pose;
    text += fmt::format("{}\n{}\n{}\n{} {} {} {} {} {} {}\n{:016x}\n", device.name,
                        device.on_device, device.on_link, pose.position.x, pose.position.y,
                        pose.position.z, pose.orientation.x, pose.orientation.y, pose.orientation.z,
                        pose.orientation.w, model == nullptr ? 0 : kinematicsHash(*model));
  }
  for (const auto& [name, model] : cell.models) {
    text += fmt::format("{}\n{:016x}\n", name, model == nullptr ? 0 : kinematicsHash(*model));
  }
  return hexOf(xxh3(bytesOf(text)));
}

TrackCache TrackCache::ofUser() {
  for (const auto& [variable, below] :
       {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")}) {
    const char* const text = std::getenv(variable);
    if (text == nullptr || !fs::path(text).is_absolute()) continue;
    return TrackCache(fs::path(text) / below / "rocinante" / "runs");
  }
  return {};
}

Result<SessionTrack> TrackCache::track(const Cell& cell, const fs::path& log,
                                       const std::string& bytes_hash, Nanoseconds step) const {
  if (folder_.empty()) return trackSession(cell, log, step);
  const std::string key = hexOf(xxh3(bytesOf(
      fmt::format("{} {} {} {}", kTrackVersion, bytes_hash, step.count(), trackCellHash(cell)))));
  const fs::path file = folder_ / (key + std::string(kTrackExtension));
  // A kept file is replaced and removed, never changed: a mapping of it stays whole.
  if (const auto kept = MappedFile::open(file); kept.ok() && kept->bytes().size() <= kMaxBytes) {
    if (auto track = decodeTrack(kept->bytes(), key)) {
      std::error_code ignored;
      fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
      return std::move(*track);
    }
  }
  auto track = trackSession(cell, log, step);
  if (!track.ok()) return track;
  const Bytes bytes = encodeTrack(*track, key);
  std::error_code refused;
  fs::create_directories(folder_, refused);
  if (refused || bytes.size() > kMaxBytes) return track;
  makeRoomFor(bytes.size());
  static_cast<void>(writeFileWhole(file, bytes, true, Sync::later).has_value());
  return track;
}

void TrackCache::makeRoomFor(std::uint64_t bytes) const {
  struct KeptTrack {
    fs::file_time_type used;
    fs::path file;
    std::uint64_t bytes;
  };
  std::vector<KeptTrack> kept;
  std::uint64_t total = bytes;
  std::error_code fault;
  for (fs::directory_iterator at(folder_, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code gone;
    if (!isTrackFile(at->path()) || !at->is_regular_file(gone)) continue;
    const std::uint64_t size = at->file_size(gone);
    const auto used = at->last_write_time(gone);
    if (gone) continue;
    total += size;
    kept.push_back({used, at->path(), size});
  }
  std::ranges::sort(kept, [](const KeptTrack& a, const KeptTrack& b) {
    return a.used != b.used ? a.used < b.used : a.file < b.file;
  });
  for (const KeptTrack& oldest : kept) {
    if (total <= kMaxBytes) return;
    if (fs::remove(oldest.file, fault)) total -= oldest.bytes;
  }
}

}  // namespace rocinante
