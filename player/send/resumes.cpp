#include "player/send/resumes.h"

#include <signal.h>

#include <atomic>

namespace rocinante {
namespace {

std::atomic<std::uint32_t> resumes{0};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "written by a signal handler");

}  // namespace

void watchResumes() {
  struct sigaction action {};
  action.sa_handler = [](int) { noteResume(); };
  // System calls of other threads must not fail because of this signal.
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGCONT, &action, nullptr);
}

void noteResume() { resumes.fetch_add(1, std::memory_order_relaxed); }

std::uint32_t resumeCount() { return resumes.load(std::memory_order_relaxed); }

}  // namespace rocinante
