#include "tests/bench/replay/replay_wire.h"

#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/net/udp_socket.h"
#include "tests/bench/replay/replay_schedule.h"

namespace rocinante::bench {
namespace {

using std::chrono::milliseconds;

constexpr const char* kNear = "replay0";
constexpr const char* kFar = "replay1";

bool runs(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

Error refused(const std::string& what) {
  return {ErrorKind::refused, what + ": " + std::strerror(errno), {}};
}

}  // namespace

/// Plain atomics in shared memory.
struct ReplayWire::Heard {
  std::atomic<std::uint64_t> count;
  std::atomic<std::uint64_t> disorder;
  std::atomic<std::int64_t> highest;
  std::array<std::atomic<std::int64_t>, kMax> at_ns;
};

namespace {

/// The listening process: never comes back.
template <class Heard>
[[noreturn]] void listen(Heard& heard, int ready, int go) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  char told = 0;
  if (::unshare(CLONE_NEWNET) != 0 || ::write(ready, "n", 1) != 1 || ::read(go, &told, 1) != 1) {
    ::_exit(2);
  }
  const bool is_up =
      runs(fmt::format("ip address add 10.77.0.2/24 dev {0} && ip link set {0} up "
                       "&& ip link set lo up",
                       kFar));
  auto receiver = UdpReceiver::open(
      Endpoint::parse(fmt::format("udp://239.255.76.67:7667?interface={}", kFar)).value());
  if (!is_up || !receiver.ok() || ::write(ready, "r", 1) != 1) ::_exit(2);
  while (true) {
    const auto batch = receiver->receive();
    if (!batch.ok()) ::_exit(2);
    for (const ReceivedDatagram& datagram : *batch) {
      const std::int64_t number = numberOf(datagram.payload);
      if (number < 0 || number >= static_cast<std::int64_t>(ReplayWire::kMax)) continue;
      auto& place = heard.at_ns[static_cast<std::size_t>(number)];
      if (place.load() != 0 || number < heard.highest.load()) heard.disorder.fetch_add(1);
      if (place.load() == 0) heard.count.fetch_add(1);
      heard.highest.store(number);
      place.store(datagram.kernel_time.time_since_epoch().count());
    }
    if (batch->empty()) std::this_thread::sleep_for(milliseconds(1));
  }
}

}  // namespace

Result<std::unique_ptr<ReplayWire>> ReplayWire::make() {
  void* const memory =
      ::mmap(nullptr, sizeof(Heard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return refused("no memory to share");
  // Zeroed pages are what empty atomics look like.
  std::unique_ptr<ReplayWire> wire(new ReplayWire(static_cast<Heard*>(memory)));
  int ready[2];
  int go[2];
  if (::pipe(ready) != 0 || ::pipe(go) != 0) return refused("no pipe");
  if (::unshare(CLONE_NEWNET) != 0) return refused("no network namespace of its own");
  wire->listener_ = ::fork();
  if (wire->listener_ == 0) listen(*wire->heard_, ready[1], go[0]);
  ::close(ready[1]);
  ::close(go[0]);
  char told = 0;
  const bool has_namespace = ::read(ready[0], &told, 1) == 1;
  const bool is_wired =
      has_namespace &&
      runs(fmt::format("ip link add {0} type veth peer name {1} netns {2} && ip address add "
                       "10.77.0.1/24 dev {0} && ip link set {0} up && ip link set lo up && ip "
                       "route add 224.0.0.0/4 dev {0}",
                       kNear, kFar, wire->listener_));
  if (!is_wired || ::write(go[1], "g", 1) != 1 || ::read(ready[0], &told, 1) != 1) {
    return Error{ErrorKind::refused, "no veth pair could be made (ip of iproute2)", {}};
  }
  ::close(ready[0]);
  ::close(go[1]);
  return wire;
}

ReplayWire::~ReplayWire() {
  if (listener_ > 0) {
    ::kill(listener_, SIGKILL);
    ::waitpid(listener_, nullptr, 0);
  }
  ::munmap(heard_, sizeof(Heard));
}

Endpoint ReplayWire::to() const {
  return Endpoint::parse(fmt::format("udp://239.255.76.67:7667?interface={}&ttl=1", kNear)).value();
}

SocketAddress ReplayWire::from() const { return SocketAddress::parse("10.77.0.1", 7667).value(); }

std::string ReplayWire::interface() const { return kNear; }

void ReplayWire::clear(std::size_t count) {
  for (std::size_t i = 0; i < std::min(count, kMax); ++i) heard_->at_ns[i].store(0);
  heard_->count.store(0);
  heard_->disorder.store(0);
  heard_->highest.store(-1);
}

void ReplayWire::settle(std::size_t count) const {
  std::uint64_t before = 0;
  for (int idle = 0; idle < 5; ++idle) {
    const std::uint64_t now = heard_->count.load();
    if (now >= count) return;
    if (now != before) idle = 0;
    before = now;
    std::this_thread::sleep_for(milliseconds(50));
  }
}

std::vector<std::int64_t> ReplayWire::arrivals(std::size_t count) const {
  std::vector<std::int64_t> arrivals(count);
  for (std::size_t i = 0; i < count; ++i) arrivals[i] = heard_->at_ns[i].load();
  return arrivals;
}

std::uint64_t ReplayWire::disorder() const { return heard_->disorder.load(); }

}  // namespace rocinante::bench
