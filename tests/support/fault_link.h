#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <queue>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rocinante::test {

/// What a bad link does to each datagram, in either direction.
struct LinkFaults {
  double loss = 0;       ///< probability
  double duplicate = 0;  ///< probability of a second copy, which is delayed for itself
  std::chrono::microseconds delay{0};
  std::chrono::microseconds jitter{0};  ///< added at random, up to this: reorders
  double bits_per_second = 0;           ///< 0: as fast as loopback; IP and UDP headers count
  std::size_t queue_bytes = 4'000;      ///< what waits for a slow link; the rest is dropped
};

/// What happened so far, both directions together.
struct LinkCounts {
  std::uint64_t arrived = 0, passed = 0, lost = 0, duplicated = 0, overflowed = 0;
};

/// A bad link between two programs on loopback (IPv4): whoever sends to port() is forwarded to
/// `to` from a port of the link's own, and what comes back goes to whoever sent last. Faults are
/// drawn from `seed`. A thread of its own, ended by the destructor.
class FaultLink {
 public:
  using Clock = std::chrono::steady_clock;

  FaultLink(std::uint16_t to, LinkFaults faults, std::uint32_t seed = 1996)
      : faults_(faults), random_(seed), near_(openSocket(0)), far_(openSocket(to)) {
    sockaddr_in own{};
    socklen_t length = sizeof own;
    ::getsockname(near_, reinterpret_cast<sockaddr*>(&own), &length);
    port_ = ntohs(own.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~FaultLink() {
    stop_ = true;
    thread_.join();
    ::close(near_);
    ::close(far_);
  }
  FaultLink(const FaultLink&) = delete;
  FaultLink& operator=(const FaultLink&) = delete;

  std::uint16_t port() const { return port_; }
  void setFaults(LinkFaults faults) {
    const std::lock_guard lock(mutex_);
    faults_ = faults;
  }
  LinkCounts counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  struct Waiting {
    Clock::time_point at;
    std::uint64_t order;
    int socket;
    std::vector<char> bytes;
    bool operator>(const Waiting& other) const {
      return at != other.at ? at > other.at : order > other.order;
    }
  };

  /// Bound to a free port of loopback, and connected to `to` unless that is 0.
  static int openSocket(std::uint16_t to) {
    const int made = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int bytes = 4 << 20;
    ::setsockopt(made, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (made < 0 || ::bind(made, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error("no socket for a bad link");
    }
    address.sin_port = htons(to);
    if (to != 0) ::connect(made, reinterpret_cast<sockaddr*>(&address), sizeof address);
    return made;
  }

  bool chance(double probability) {
    return std::uniform_real_distribution<double>(0, 1)(random_) < probability;
  }

  void take(int from, int to, Clock::time_point& link_free) {
    std::array<char, 65'536> buffer;
    for (;;) {
      sockaddr_in sender{};
      socklen_t length = sizeof sender;
      const ssize_t size = ::recvfrom(from, buffer.data(), buffer.size(), 0,
                                      reinterpret_cast<sockaddr*>(&sender), &length);
      if (size < 0 && errno == EAGAIN) return;
      if (size < 0) continue;  // nobody listens at the other end: not the link's fault
      if (from == near_) peer_ = sender;
      const std::lock_guard lock(mutex_);
      ++counts_.arrived;
      if (chance(faults_.loss)) {
        ++counts_.lost;
        continue;
      }
      const bool twice = chance(faults_.duplicate);
      counts_.duplicated += twice ? 1 : 0;
      for (int copy = 0; copy < (twice ? 2 : 1); ++copy) {
        enqueue({buffer.data(), buffer.data() + size}, to, link_free);
      }
    }
  }

  void enqueue(std::vector<char> bytes, int to, Clock::time_point& link_free) {
    const auto now = Clock::now();
    auto at = now;
    if (faults_.bits_per_second > 0) {
      const auto seconds = [&](double count) {
        return std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(count * 8 / faults_.bits_per_second));
      };
      if (link_free - now > seconds(static_cast<double>(faults_.queue_bytes))) {
        ++counts_.overflowed;
        return;
      }
      at = link_free = std::max(now, link_free) + seconds(static_cast<double>(bytes.size() + 28));
    }
    at += faults_.delay;
    if (faults_.jitter.count() > 0) {
      at += std::chrono::microseconds(
          std::uniform_int_distribution<std::int64_t>(0, faults_.jitter.count())(random_));
    }
    waiting_.push({at, order_++, to, std::move(bytes)});
  }

  void deliver() {
    while (!waiting_.empty() && waiting_.top().at <= Clock::now()) {
      const Waiting& next = waiting_.top();
      if (next.socket == far_) {
        ::send(far_, next.bytes.data(), next.bytes.size(), 0);
      } else if (peer_) {
        ::sendto(near_, next.bytes.data(), next.bytes.size(), 0,
                 reinterpret_cast<const sockaddr*>(&*peer_), sizeof *peer_);
      }
      waiting_.pop();
      const std::lock_guard lock(mutex_);
      ++counts_.passed;
    }
  }

  void run() {
    while (!stop_) {
      std::array<pollfd, 2> polled{{{near_, POLLIN, 0}, {far_, POLLIN, 0}}};
      ::poll(polled.data(), polled.size(), waiting_.empty() ? 20 : 1);
      take(near_, far_, link_free_[0]);
      take(far_, near_, link_free_[1]);
      deliver();
    }
  }

  mutable std::mutex mutex_;
  LinkFaults faults_;
  LinkCounts counts_;
  std::mt19937 random_;
  int near_, far_;
  std::uint16_t port_ = 0;
  std::optional<sockaddr_in> peer_;
  std::array<Clock::time_point, 2> link_free_{};
  std::uint64_t order_ = 0;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace rocinante::test
