#pragma once

#include <signal.h>

#include <filesystem>
#include <string>

namespace rocinante {

/// A file, or a folder with nothing else in it, that is removed when the work on it ends early: by
/// the destructor, or by a signal that ends the process (cli::StopDeadline). Not for sharing
/// between threads.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  explicit UnfinishedPath(std::filesystem::path path);
  ~UnfinishedPath();
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;

  /// Keeps the path: it is finished, or was renamed.
  void keep();

 private:
  struct Entry;
  friend void removeUnfinishedPaths();
  static Entry* entryFor(std::string path);

  Entry* entry_ = nullptr;  ///< never freed: a signal handler may look at it at any time
};

/// Removes all unfinished paths, the latest first. Safe in signal handlers.
void removeUnfinishedPaths();

/// While it lives, stop signals are blocked in this thread, so that files get all their names or
/// none.
class EndingHeld {
 public:
  EndingHeld();
  ~EndingHeld();
  EndingHeld(const EndingHeld&) = delete;
  EndingHeld& operator=(const EndingHeld&) = delete;

 private:
  sigset_t former_;
};

}  // namespace rocinante
