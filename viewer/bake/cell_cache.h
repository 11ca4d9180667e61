#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/cache_folder.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cell/cell.h"

namespace rocinante {

/// Keeps loaded cells between runs, baked with decoded pictures, so that a large cell opens in a
/// moment. A kept cell is used only if everything that it was made of is as it was: the text of the
/// request, every file by its content, every answer of the file system to the search, the code that
/// read it, and the libraries of that process (cell_inputs.h). It then equals what loading would
/// give, and its pictures have the same bits. Never fails: an entry that is damaged or outdated is
/// made again. Several threads and processes may use one folder at a time.
class CellCache {
 public:
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{512} << 20;
  /// Cells of fewer bytes are not kept: they open in no time.
  static constexpr std::uint64_t kLeastBytes = std::uint64_t{256} << 10;

  /// A cache that keeps nothing.
  CellCache() = default;
  /// Deletes the least recently used files when they take more than `most_bytes`.
  explicit CellCache(std::filesystem::path folder, std::uint64_t most_bytes = kDefaultBytes,
                     std::uint64_t least_bytes = kLeastBytes)
      : files_(std::move(folder), ".rkcell", most_bytes), least_bytes_(least_bytes) {}

  /// XDG_CACHE_HOME/rocinante/cells, else HOME/.cache/rocinante/cells; keeps nothing if neither is
  /// an absolute path.
  static CellCache ofUser();

  /// For tests: the time, in place of the system's.
  void tellTimeBy(std::function<WallTime()> now) { now_ = std::move(now); }

  const std::filesystem::path& folder() const { return files_.path(); }

  /// loadCellOrLog(), from the cache or into it. What is not kept: a cell in a log, one with
  /// errors, or without geometry, and loads whose names are answered or noted by the caller.
  Result<Cell> load(const std::filesystem::path& path, const CellOptions& options) const;

 private:
  std::optional<Cell> kept(const std::string& key, const CellOptions& options) const;
  Cell keep(Cell cell, const std::string& key, const CellOptions& options, const SearchFacts& facts,
            WallTime begun) const;

  CacheFolder files_;
  std::uint64_t least_bytes_ = kLeastBytes;
  std::function<WallTime()> now_;
};

}  // namespace rocinante
