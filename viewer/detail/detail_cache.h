#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
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

/// The bytes of one file of the cache, as StructWriter writes them: the versions of this layout and
/// of meshoptimizer, the key, the parts, the indices; then the XXH3 of all of it. Little-endian.
Bytes encodeDetail(const MeshDetail& detail, std::string_view key);

/// Empty unless encodeDetail() wrote the bytes for this mesh: for another version or key, damage,
/// truncation, or an index past the mesh's vertices. Lengths are checked before allocation.
std::optional<MeshDetail> decodeDetail(ByteView bytes, std::string_view key,
                                       const DetailInput& input);

}  // namespace rocinante
