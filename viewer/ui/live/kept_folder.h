#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// A live session that a window kept and did not delete: it was killed.
struct KeptLeftover {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> pieces;  ///< its logs, by name, oldest first
  std::uint64_t bytes = 0;
};

/// The folder of one window for its kept log, below the cache folder. It is locked while this lives
/// and deleted with all that is in it at the end. Move-only.
class KeptFolder {
 public:
  /// $XDG_CACHE_HOME/rocinante/live, else $HOME/.cache/rocinante/live; empty when neither is an
  /// absolute path.
  static std::filesystem::path ofUser();

  /// A new folder below `parent`, which is made if it is missing. unreadable when that fails,
  /// bad_argument when `parent` is empty.
  static Result<KeptFolder> make(const std::filesystem::path& parent);
  /// The folders below `parent` whose windows are gone, oldest first. Folders without logs are
  /// removed on the way.
  static std::vector<KeptLeftover> leftovers(const std::filesystem::path& parent);
  /// Deletes a leftover; an error when another program has taken it, or the system refuses.
  static Status forget(const KeptLeftover& leftover);

  ~KeptFolder();
  KeptFolder(KeptFolder&& other) noexcept;
  KeptFolder& operator=(KeptFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  KeptFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path path_;
  int lock_;
};

/// One sentence that offers the leftovers, for the start of a window; empty when there are none.
std::string leftoversOffer(const std::vector<KeptLeftover>& leftovers);
/// What `rocinante view --leftovers` prints: a line each, and how to keep or delete them.
std::string leftoversText(const std::vector<KeptLeftover>& leftovers);

}  // namespace rocinante
