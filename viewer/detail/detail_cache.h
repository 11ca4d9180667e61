#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/cache_folder.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante {

/// Keeps results of makeMeshDetail() between runs: one file per mesh, named after its key. Never
/// fails: a damaged, foreign or unreadable file counts as missing, and write errors are ignored.
/// Several threads and processes may use one folder at a time; files appear whole.
class DetailCache {
 public:
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{512} << 20;

  /// A cache that keeps nothing.
  DetailCache() = default;
  /// Deletes the least recently used files when they take more than `most_bytes`.
  explicit DetailCache(std::filesystem::path folder, std::uint64_t most_bytes = kDefaultBytes);

  /// XDG_CACHE_HOME/rocinante/lod, else HOME/.cache/rocinante/lod; keeps nothing if neither is an
  /// absolute path.
  static DetailCache ofUser();

  const std::filesystem::path& folder() const { return files_.path(); }

  std::optional<MeshDetail> load(const std::string& key, const DetailInput& input) const;
  void store(const std::string& key, const MeshDetail& detail) const;

 private:
  CacheFolder files_;
};

}  // namespace rocinante
