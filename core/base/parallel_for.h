#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace rocinante {

/// Calls `task(i)` once for each i below `count`, in any order and on any thread, and returns when
/// all calls have returned. The library starts no threads for this: a caller that has threads
/// passes them in. Results must not depend on the order.
using ParallelFor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// One after another where `parallel` is empty.
inline void forEachIndex(const ParallelFor& parallel, std::size_t count,
                         const std::function<void(std::size_t)>& task) {
  if (parallel && count > 1) return parallel(count, task);
  for (std::size_t i = 0; i < count; ++i) task(i);
}

/// Progress of loading files.
struct LoadProgress {
  std::size_t files_done = 0, files_total = 0;
  std::uint64_t bytes_done = 0, bytes_total = 0;
};

/// Called by one thread at a time, but any thread that loads.
using TellLoadProgress = std::function<void(const LoadProgress&)>;

}  // namespace rocinante
