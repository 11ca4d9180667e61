#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "viewer/detail/mesh_detail.h"

namespace rocinante {

/// Keeps what makeMeshDetail() made from one run of a program to the next: one file a mesh, named
/// after its key. Nothing here can fail for its user: a damaged, foreign or unreadable file is as
/// none, and where nothing can be written nothing is kept. Several threads and processes may use
/// one folder at a time; files appear whole.
class DetailCache {
 public:
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{512} << 20;

  /// Keeps nothing.
  DetailCache() = default;
  /// When the files take more than `most_bytes`, those longest unused go.
  explicit DetailCache(std::filesystem::path folder, std::uint64_t most_bytes = kDefaultBytes)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// XDG_CACHE_HOME/rocinante/lod, else HOME/.cache/rocinante/lod; one that keeps nothing where
  /// neither is an absolute path.
  static DetailCache ofUser();

  const std::filesystem::path& folder() const { return folder_; }

  std::optional<MeshDetail> load(const std::string& key, const DetailInput& input) const;
  void store(const std::string& key, const MeshDetail& detail) const;

 private:
  std::filesystem::path fileOf(const std::string& key) const;
  void makeRoom(std::uint64_t bytes) const;

  std::filesystem::path folder_;  ///< empty: none
  std::uint64_t most_bytes_ = 0;
};

}  // namespace rocinante
