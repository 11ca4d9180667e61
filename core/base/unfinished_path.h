#pragma once

#include <signal.h>

#include <filesystem>
#include <string>

namespace rocinante {

/// A file, or a folder with nothing else in it, that goes when the work on it ends early: by the
/// destructor, or by a signal that ends the process (cli::StopDeadline). Not for sharing between
/// threads.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  explicit UnfinishedPath(std::filesystem::path path);
  ~UnfinishedPath();
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;

  /// It is finished, or has another name by now: it stays.
  void keep();

 private:
  struct Entry;
  friend void removeUnfinishedPaths();
  static Entry* entryFor(std::string path);

  Entry* entry_ = nullptr;  ///< never freed: a signal handler may look at it at any time
};

/// Removes all that are unfinished, the latest first. For signal handlers too.
void removeUnfinishedPaths();

/// While it lives, this thread takes no signal that ends work early: names are given all or none.
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
