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

/// Progress of loading files.
struct LoadProgress {
  std::size_t files_done = 0, files_total = 0;
  std::uint64_t bytes_done = 0, bytes_total = 0;
};

/// Called by one thread at a time, but any thread that loads.
using TellLoadProgress = std::function<void(const LoadProgress&)>;

}  // namespace rocinante
