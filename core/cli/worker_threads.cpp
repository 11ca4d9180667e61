#include "core/cli/worker_threads.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace rocinante::cli {
namespace {

// hardware_concurrency() ignores a container's CPU set.
std::size_t coresAllowed() {
  cpu_set_t cores;
  if (::sched_getaffinity(0, sizeof cores, &cores) != 0) return 1;
  return static_cast<std::size_t>(std::max(CPU_COUNT(&cores), 1));
}

}  // namespace

ParallelFor workerThreads() {
  return [](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    std::vector<std::jthread> others;
    const std::size_t wanted = std::min(coresAllowed(), count);
    for (std::size_t i = 1; i < wanted; ++i) others.emplace_back(work);
    work();
  };
}

}  // namespace rocinante::cli
