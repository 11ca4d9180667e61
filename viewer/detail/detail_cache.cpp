#include "viewer/detail/detail_cache.h"

#include "core/base/atomic_file.h"

namespace rocinante {

DetailCache::DetailCache(std::filesystem::path folder, std::uint64_t most_bytes)
    : files_(std::move(folder), ".lod", most_bytes) {}

DetailCache DetailCache::ofUser() { return DetailCache(CacheFolder::ofUser("lod")); }

std::optional<MeshDetail> DetailCache::load(const std::string& key,
                                            const DetailInput& input) const {
  if (folder().empty()) return std::nullopt;
  const auto content = readFile(files_.fileOf(key), files_.mostBytes());
  if (!content.ok()) return std::nullopt;
  auto detail = decodeDetail(bytesOf(*content), key, input);
  if (detail) files_.touch(key);
  return detail;
}

void DetailCache::store(const std::string& key, const MeshDetail& detail) const {
  if (!folder().empty()) files_.store(key, encodeDetail(detail, key));
}

}  // namespace rocinante
