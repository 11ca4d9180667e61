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

/// Runs tasks on its own threads, so that pictures are encoded and written while the next one is
/// drawn. Tasks must not depend on each other. The queue is short, which bounds memory: add()
/// blocks when it is full. After a failed task, tasks that have not started are dropped.
class BackgroundWriter {
 public:
  BackgroundWriter();
  /// Waits for added tasks.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Returns the error of an earlier failed task, if any; this one may fail later.
  Status add(std::function<Status()> task);
  /// Waits for all tasks; returns the first error.
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
