#pragma once

#include <poll.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "core/net/udp_socket.h"
#include "tests/core/subscription/fake_relay.h"

namespace rocinante::test {

/// A FakeRelay on a port of this machine, in a thread of its own.
class LoopbackRelay {
 public:
  explicit LoopbackRelay(std::string_view address = "127.0.0.1:0")
      : socket_(UdpReceiver::open(Endpoint::parse(address).value()).value()),
        thread_([this] { serve(); }) {}
  ~LoopbackRelay() {
    stop_ = true;
    thread_.join();
  }

  std::string endpoint() const { return "subscribe://" + socket_.boundAddress().text(); }
  SocketAddress address() const { return socket_.boundAddress(); }

  /// Looks at or changes the relay between two requests.
  void with(const std::function<void(FakeRelay&)>& use) {
    const std::lock_guard lock(mutex_);
    use(relay_);
  }
  /// Waits until it holds, at most 20 s.
  bool waitUntil(const std::function<bool(const FakeRelay&)>& holds) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < give_up) {
      {
        const std::lock_guard lock(mutex_);
        if (holds(relay_)) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
  /// Answers nothing and sends nothing while it is away.
  void setAway(bool away) { away_ = away; }
  /// To the subscriber; false when there is none.
  bool send(std::string_view datagram) {
    const std::lock_guard lock(mutex_);
    if (away_ || !relay_.isServing(std::chrono::steady_clock::now())) return false;
    return socket_.sendTo(subscriber_, bytesOf(datagram)).ok();
  }
  SocketAddress subscriber() {
    const std::lock_guard lock(mutex_);
    return subscriber_;
  }

 private:
  void serve() {
    while (!stop_) {
      pollfd waiting{socket_.fileDescriptor(), POLLIN, 0};
      ::poll(&waiting, 1, 10);
      const auto batch = socket_.receive();
      if (!batch || away_) continue;
      const std::lock_guard lock(mutex_);
      for (const ReceivedDatagram& each : *batch) {
        const auto answer = relay_.answer(textOf(each.payload), std::chrono::steady_clock::now());
        subscriber_ = each.sender;
        if (answer) (void)socket_.sendTo(each.sender, bytesOf(*answer));
      }
    }
  }

  UdpReceiver socket_;
  std::mutex mutex_;
  FakeRelay relay_;
  SocketAddress subscriber_;
  std::atomic<bool> away_{false}, stop_{false};
  std::thread thread_;  ///< last: it uses the members above
};

}  // namespace rocinante::test
