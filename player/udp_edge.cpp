#include "player/udp_edge.h"

#include <time.h>

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

// Longer without a sleep, a real-time thread is close to being throttled (950 ms of each second).
constexpr Nanoseconds kLongestAwake = std::chrono::milliseconds(300);

}  // namespace

Result<UdpEdge> UdpEdge::open(const Endpoint& to, Realtime realtime, std::function<bool()> stop) {
  Result<UdpSender> sender = UdpSender::open(to);
  if (!sender) return sender.error();
  Result<PacingThread> thread = PacingThread::begin(realtime);
  if (!thread) return thread.error();
  return UdpEdge(std::move(*sender), std::move(*thread), std::move(stop));
}

UdpEdge::UdpEdge(UdpSender sender, PacingThread thread, std::function<bool()> stop)
    : sender_(std::move(sender)),
      thread_(std::move(thread)),
      stop_(std::move(stop)),
      stamps_(sender_.fileDescriptor()),
      last_sleep_(now()) {}

SteadyTime UdpEdge::now() { return std::chrono::steady_clock::now(); }

void UdpEdge::sleepUntil(SteadyTime moment) {
  const Nanoseconds since_boot = moment.time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since_boot);
  const timespec wake{seconds.count(), (since_boot - seconds).count()};
  ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr);
  last_sleep_ = now();
}

Status UdpEdge::send(std::span<const ByteView> payloads, std::span<SteadyTime> sent_at) {
  if (Status sent = sender_.send(payloads); !sent) return sent;
  const SteadyTime after = now();
  std::fill(sent_at.begin(), sent_at.end(), after);
  stamps_.collect(sent_at);
  if (thread_.isRealtime() && after - last_sleep_ > kLongestAwake) thread_.leaveRealtime();
  return {};
}

std::string UdpEdge::timingSource() const {
  if (stamps_.stamped() == 0) return "clock";
  return stamps_.unstamped() == 0 ? "kernel" : "kernel and clock";
}

}  // namespace rocinante
