#include "player/send/realtime.h"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace rocinante {
namespace {

// Above ordinary threads, and below the usual priority of a machine's control loops.
constexpr int kPriority = 10;

/// From linux/sched/types.h, which conflicts with <sched.h>.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime_ns = 0, deadline_ns = 0, period_ns = 0;
};

/// An ordinary thread with a shorter time slice runs sooner (since Linux 6.12; without effect
/// before). The default is some milliseconds.
void askForShortSlices() {
  SchedulingAttributes attributes;
  attributes.nice = ::getpriority(PRIO_PROCESS, 0);
  attributes.runtime_ns = 100'000;
  ::syscall(SYS_sched_setattr, 0, &attributes, 0U);
}

}  // namespace

Realtime realtimeOf(std::string_view text) {
  if (text == "on") return Realtime::on;
  return text == "off" ? Realtime::off : Realtime::automatic;
}

Result<PacingThread> PacingThread::begin(Realtime realtime) {
  PacingThread thread;
  thread.former_slack_ns_ = ::prctl(PR_GET_TIMERSLACK);
  // The default slack of 50 us would delay every deadline.
  ::prctl(PR_SET_TIMERSLACK, 1);
  askForShortSlices();
  if (realtime == Realtime::off) return thread;
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  thread.realtime_ = ::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0;
  if (!thread.realtime_ && realtime == Realtime::on) {
    return Error{ErrorKind::refused,
                 std::string("real-time scheduling is not permitted: ") + std::strerror(errno),
                 "--realtime on"};
  }
  return thread;
}

PacingThread::PacingThread(PacingThread&& other) noexcept
    : owner_(std::exchange(other.owner_, false)),
      realtime_(std::exchange(other.realtime_, false)),
      former_slack_ns_(other.former_slack_ns_) {}

PacingThread::~PacingThread() {
  if (!owner_) return;
  leaveRealtime();
  // 0 restores the thread's default, for a negative (failed) reading.
  ::prctl(PR_SET_TIMERSLACK, former_slack_ns_ > 0 ? former_slack_ns_ : 0);
}

void PacingThread::leaveRealtime() {
  if (!std::exchange(realtime_, false)) return;
  sched_param parameters{};
  ::sched_setscheduler(0, SCHED_OTHER, &parameters);
}

}  // namespace rocinante
