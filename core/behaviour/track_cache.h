#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/cache_folder.h"
#include "core/base/result.h"
#include "core/behaviour/session_track.h"
#include "core/log/mapped_file.h"

namespace rocinante {

/// A track as a file of this machine's byte order: its samples, then this: everything else, the
/// key, and a checksum of all.
Bytes encodeTrackTail(const SessionTrack& track, std::string_view key);
/// The track of a file of that key, which it keeps; empty for anything else.
std::optional<SessionTrack> decodeTrack(MappedFile file, std::string_view key);

/// Keeps the tracks of accepted logs between runs: one file each, named by its key. Never fails:
/// what is missing, damaged or of another version is made again, and write errors are ignored.
class TrackCache {
 public:
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{4} << 30;

  /// A cache that keeps nothing.
  TrackCache() = default;
  explicit TrackCache(std::filesystem::path folder)
      : files_(std::move(folder), ".track", kMaxBytes) {}
  /// XDG_CACHE_HOME/rocinante/runs, else HOME/.cache/rocinante/runs; keeps nothing if neither is an
  /// absolute path.
  static TrackCache ofUser() { return TrackCache(CacheFolder::ofUser("runs")); }

  /// trackSession(), or what it returned before for a file of these bytes (their XXH3-128) and a
  /// cell of these kinematics, with poses of these links.
  Result<SessionTrack> track(const Cell& cell, const std::filesystem::path& log,
                             const std::string& bytes_hash,
                             const std::vector<std::string>& links = {}) const;

 private:
  CacheFolder files_;
};

/// A hash of everything of a cell that a track depends on: devices, where they are, and their
/// kinematics.
std::string trackCellHash(const Cell& cell);

}  // namespace rocinante
