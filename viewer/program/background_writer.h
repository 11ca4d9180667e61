#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Does tasks on threads of its own, so that encoding and writing pictures goes on while the next
/// one is drawn. Tasks must not depend on each other. Few wait at a time: memory stays bounded, and
/// who adds waits. After a task that failed those that were not begun are dropped.
class BackgroundWriter {
 public:
  BackgroundWriter();
  /// Waits for what was added.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// The answer of a task that has failed, if any; this one may fail later.
  Status add(std::function<Status()> task);
  /// Waits until all is done: the same.
  Status finish();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<Status()>> waiting_;
  std::size_t busy_ = 0;
  bool ending_ = false;
  std::optional<Error> failure_;
  std::vector<std::thread> threads_;  // last: they use all of the above
};

}  // namespace rocinante
