#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Keeps the logs of imported recordings between runs: `KEY.mcap`, and `KEY.sum` with its size and
/// hash. Several processes may use one folder: a log is made by one of them while the others wait,
/// and appears whole or not at all. A damaged one is deleted and made again. Not for sharing
/// between threads.
class ImportCache {
 public:
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{8} << 30;

  /// `folder` is made when it is first needed. Above `most_bytes` the least recently used logs are
  /// deleted, but never the one that was just made.
  explicit ImportCache(std::filesystem::path folder, std::uint64_t most_bytes = kDefaultBytes)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// This user's: in XDG_CACHE_HOME/rocinante/imports, else HOME/.cache/rocinante/imports; empty
  /// when neither names a folder. Never beside a recording: what lies there came from whoever made
  /// the recording, and leaving files there surprises whoever owns it (docs/decisions/035).
  static std::optional<ImportCache> ofUser();

  const std::filesystem::path& folder() const { return folder_; }

  /// The whole, undamaged log of `key`, which now counts as used. Empty when there is none.
  std::optional<std::filesystem::path> find(const std::string& key) const;

  /// Makes a file at the path that it is given.
  using Make = std::function<Status(const std::filesystem::path&)>;
  /// Called while another process makes the log; an error ends the wait.
  using Waiting = std::function<Status()>;
  struct Made {
    std::filesystem::path log;  ///< empty when the folder cannot hold it: `trouble` says why
    std::optional<Error> trouble;
  };
  /// The log of `key`, made by `make` unless another process makes it meanwhile. Errors are those
  /// of `make` that do not come from the folder, and of `waiting`.
  Result<Made> findOrMake(const std::string& key, const Make& make, const Waiting& waiting) const;

 private:
  std::filesystem::path fileOf(const std::string& key, const char* extension) const;
  Status openFolder() const;
  void makeRoom(const std::string& kept_key) const;

  std::filesystem::path folder_;
  std::uint64_t most_bytes_;
};

}  // namespace rocinante
