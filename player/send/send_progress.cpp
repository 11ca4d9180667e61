#include "player/send/send_progress.h"

#include <fmt/format.h>
#include <signal.h>

#include <atomic>

#include "core/base/duration_text.h"

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

std::string progressText(LogTime position, LogTime origin, LogTime end, std::uint64_t sent) {
  constexpr Nanoseconds kTenth = std::chrono::milliseconds(100);
  return fmt::format("{} of {} s, {} datagrams",
                     secondsText((position - origin) / kTenth * kTenth, 1),
                     secondsText((end - origin) / kTenth * kTenth, 1), sent);
}

SendProgress::SendProgress(SendJournal& behind, LogTime origin, LogTime end, bool visible)
    : behind_(behind),
      position_ns_(origin.time_since_epoch().count()),
      line_(
          [this, origin, end] {
            return progressText(LogTime(Nanoseconds(position_ns_.load(std::memory_order_relaxed))),
                                origin, end, sent_.load(std::memory_order_relaxed));
          },
          visible) {}

void SendProgress::sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) {
  behind_.sent(due, payload, deadline, sent_at);
  if (due.restated) return;
  position_ns_.store(due.time.time_since_epoch().count(), std::memory_order_relaxed);
  sent_.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace rocinante
