#include "player/send/udp_send_port.h"

#include <poll.h>
#include <time.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "core/net/udp_socket.h"
#include "core/transport/open_sink.h"
#include "player/send/send_progress.h"

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

/// What is sent to a server that is not there would only wait.
Status waitUntilReady(DatagramSink& sink, const std::function<bool()>& stop,
                      const std::function<void(std::string_view)>& notify) {
  while (!stop()) {
    const Result<bool> ready = sink.isReady();
    if (!ready) return ready.error();
    if (const auto news = sink.news(); news && notify) notify(*news);
    if (*ready) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return {};
}

}  // namespace

Result<UdpSendPort> UdpSendPort::open(const std::vector<Route>& routes, Realtime realtime,
                                      std::function<bool()> stop, int wake,
                                      const std::function<void(std::string_view)>& notify) {
  std::vector<Way> ways;
  ways.reserve(routes.size());
  for (const Route& route : routes) {
    Way way;
    way.restating = route.restating;
    if (route.to.isNats()) {
      auto sink = openSink(route.to);
      if (!sink) return sink.error();
      way.sink = std::move(*sink);
      if (Status ready = waitUntilReady(*way.sink, stop, notify); !ready) return ready.error();
    } else {
      Result<UdpSender> sender = UdpSender::open(route.to, route.local_port);
      if (!sender) return sender.error();
      way.sink = std::make_unique<UdpSender>(std::move(*sender));
      way.stamps.emplace(way.sink->fileDescriptor());
    }
    ways.push_back(std::move(way));
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
  const std::uint32_t count = resumeCount();
  return std::exchange(resumes_, count) != count;
}

std::size_t UdpSendPort::longest(std::uint16_t route) const {
  constexpr std::size_t kMaxUdpBytes = 65'507;
  return ways_[route].stamps ? kMaxUdpBytes : SendPort::longest(route);
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
  if (Status sent = way.sink->send(payloads); !sent) return sent;
  const SteadyTime after = now();
  std::fill(sent_at.begin(), sent_at.end(), after);
  if (way.stamps) way.stamps->collect(sent_at);
  if (thread_.isRealtime() && after - last_sleep_ > kAwake) leaveRealtimeIfHogging();
  return {};
}

Status UdpSendPort::flush() {
  for (const Way& way : ways_) {
    if (Status flushed = way.sink->flush(); !flushed) return flushed;
  }
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
    any_stamped = any_stamped || (way.stamps && way.stamps->stamped() > 0);
    all_stamped = all_stamped && way.stamps && way.stamps->unstamped() == 0;
  }
  if (!any_stamped) return "clock";
  return all_stamped ? "kernel" : "kernel and clock";
}

}  // namespace rocinante
