#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace rocinante {

/// Calls `task(i)` once for each i below `count`, in any order and on any threads, and returns when
/// all have returned. The library starts no threads for this: a caller that has some hands them in.
/// Results must not depend on the order.
using ParallelFor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// How far the loading of files has come.
struct LoadProgress {
  std::size_t files_done = 0, files_total = 0;
  std::uint64_t bytes_done = 0, bytes_total = 0;
};

/// One call at a time, but from any thread that loads.
using TellLoadProgress = std::function<void(const LoadProgress&)>;

}  // namespace rocinante
