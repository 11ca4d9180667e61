#include "player/send/udp_send_port.h"

#include <poll.h>
#include <time.h>

#include <algorithm>
#include <utility>

#include "player/send/resumes.h"

namespace rocinante {
namespace {

// A real-time thread that runs for 950 ms of a second is throttled; stop well before. Only the
// thread's CPU time counts: a suspended machine starved no other thread.
constexpr Nanoseconds kAwake = std::chrono::milliseconds(100);
constexpr Nanoseconds kMaxRunning = std::chrono::milliseconds(200);

Nanoseconds runningTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

}  // namespace

Result<UdpSendPort> UdpSendPort::open(const std::vector<Route>& routes, Realtime realtime,
                                      std::function<bool()> stop, int wake) {
  std::vector<Way> ways;
  ways.reserve(routes.size());
  for (const Route& route : routes) {
    Result<UdpSender> sender = UdpSender::open(route.to, route.local_port);
    if (!sender) return sender.error();
    ways.emplace_back(std::move(*sender), route.restating);
  }
  Result<PacingThread> thread = PacingThread::begin(realtime);
  if (!thread) return thread.error();
  return UdpSendPort(std::move(ways), std::move(*thread), std::move(stop), wake);
}

UdpSendPort::UdpSendPort(std::vector<Way> ways, PacingThread thread, std::function<bool()> stop,
                         int wake)
    : ways_(std::move(ways)),
      thread_(std::move(thread)),
      stop_(std::move(stop)),
      wake_(wake),
      last_sleep_(now()),
      resumes_(resumeCount()) {}

bool UdpSendPort::hasResumed() {
  const std::uint32_t resumes = resumeCount();
  return std::exchange(resumes_, resumes) != resumes;
}

SteadyTime UdpSendPort::now() { return std::chrono::steady_clock::now(); }

void UdpSendPort::sleepUntil(SteadyTime moment) {
  if (wake_ < 0) {
    const Nanoseconds since_boot = moment.time_since_epoch();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(since_boot);
    const timespec wake{seconds.count(), (since_boot - seconds).count()};
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr);
  } else if (const Nanoseconds span = moment - now(); span.count() > 0) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(span);
    const timespec most{seconds.count(), (span - seconds).count()};
    pollfd wake{wake_, POLLIN, 0};
    ::ppoll(&wake, 1, &most, nullptr);
  }
  last_sleep_ = now();
  ran_until_.reset();
}

Status UdpSendPort::send(std::uint16_t route, std::span<const ByteView> payloads,
                         std::span<SteadyTime> sent_at) {
  Way& way = ways_[route];
  if (Status sent = way.sender.send(payloads); !sent) return sent;
  const SteadyTime after = now();
  std::fill(sent_at.begin(), sent_at.end(), after);
  way.stamps.collect(sent_at);
  if (thread_.isRealtime() && after - last_sleep_ > kAwake) leaveRealtimeIfHogging();
  return {};
}

void UdpSendPort::leaveRealtimeIfHogging() {
  const Nanoseconds ran = runningTime();
  if (!ran_until_) ran_until_ = ran;
  if (ran - *ran_until_ > kMaxRunning) thread_.leaveRealtime();
}

std::string UdpSendPort::timingSource() const {
  bool any_stamped = false;
  bool all_stamped = true;
  for (const Way& way : ways_) {
    if (way.restating) continue;
    any_stamped = any_stamped || way.stamps.stamped() > 0;
    all_stamped = all_stamped && way.stamps.unstamped() == 0;
  }
  if (!any_stamped) return "clock";
  return all_stamped ? "kernel" : "kernel and clock";
}

}  // namespace rocinante
