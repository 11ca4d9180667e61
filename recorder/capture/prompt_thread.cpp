#include "recorder/capture/prompt_thread.h"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

namespace rocinante {
namespace {

constexpr int kWantedNice = -10;
constexpr std::uint64_t kSliceNs = 100'000;  // the smallest that Linux accepts

/// From linux/sched/types.h, which conflicts with the C library's sched.h.
struct SchedulingAttributes {
  std::uint32_t size;
  std::uint32_t policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime_ns;  ///< under SCHED_OTHER the time slice
  std::uint64_t deadline_ns;
  std::uint64_t period_ns;
};

bool ask(int nice) {
  SchedulingAttributes wanted{};
  wanted.size = sizeof wanted;
  wanted.policy = SCHED_OTHER;
  wanted.nice = nice;
  wanted.runtime_ns = kSliceNs;
  return ::syscall(SYS_sched_setattr, 0, &wanted, 0) == 0;
}

}  // namespace

void askToRunPromptly() {
  // A policy chosen for the whole program (chrt) takes precedence.
  if (::sched_getscheduler(0) != SCHED_OTHER) return;
  errno = 0;
  const int nice = ::getpriority(PRIO_PROCESS, 0);
  if (errno != 0) return;
  if (!ask(std::min(nice, kWantedNice))) (void)ask(nice);
}

}  // namespace rocinante
