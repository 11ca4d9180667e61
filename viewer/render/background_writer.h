#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/result.h"

namespace rocinante {

/// Does tasks one after another on a thread of its own, so that encoding and writing pictures goes
/// on while the next one is drawn. Few wait at a time: memory stays bounded, and who adds waits.
/// After a task that failed the others are dropped.
class BackgroundWriter {
 public:
  BackgroundWriter();
  /// Waits for what was added.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// The answer of the first task that failed so far; later ones may still.
  Status add(std::function<Status()> task);
  /// Waits until all is done: the answer of the first task that failed.
  Status finish();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<Status()>> waiting_;
  bool busy_ = false, ending_ = false;
  std::optional<Error> failure_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace rocinante
